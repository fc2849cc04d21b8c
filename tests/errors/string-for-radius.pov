torus { 1, "small" }

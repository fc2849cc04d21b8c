torus { 1, -1 }

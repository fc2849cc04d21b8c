sphere { 0, 1 normal { pavement } }

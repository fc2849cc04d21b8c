sphere { 0, 1 normal { tiling 25 } }

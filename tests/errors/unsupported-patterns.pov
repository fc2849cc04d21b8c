sphere { 0, 1 pigment { tiling 25 } }

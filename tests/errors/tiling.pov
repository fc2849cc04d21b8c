plane { y, 0 pigment { tiling 28 } }

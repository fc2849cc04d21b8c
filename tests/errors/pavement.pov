plane { y, 0 pigment { pavement number_of_sides 6 number_of_tiles 3 pattern 4 } }

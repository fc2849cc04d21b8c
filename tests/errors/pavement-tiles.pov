plane { y, 0 pigment { pavement number_of_sides 6 scale 2 number_of_tiles 6 } }

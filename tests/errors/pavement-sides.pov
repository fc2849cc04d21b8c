plane { y, 0 pigment { pavement number_of_sides 5 } }

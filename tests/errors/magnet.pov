sphere { 0, 1 pigment { magnet 3 mandel 5 } }
sphere { 0, 1 pigment { magnet 1 5 } }
sphere { 0, 1 pigment { magnet 1 julia 5 } }
sphere { 0, 1 pigment { magnet 1 mandel 0 } }
sphere { 0, 1 pigment { magnet 2 mandel 9 exponent 3 } }

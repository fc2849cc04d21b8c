sphere { 0, 1 pigment { aoi } }
sphere { 0, 1 pigment { cubic } }
sphere { 0, 1 pigment { pavement } }
sphere { 0, 1 pigment { square } }
sphere { 0, 1 normal { triangular } }

#declare Shell = pigment { pavement }
sphere { 0, 1 }
sphere { 0, 1 pigment { Shell } }

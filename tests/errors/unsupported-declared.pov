#declare Shell = pigment { tiling 25 }
sphere { 0, 1 }
sphere { 0, 1 pigment { Shell } }

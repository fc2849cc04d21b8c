#declare T = texture { checker texture { pigment { rgb 1 } } texture { pigment { rgb 0 } } texture { pigment { rgb x } } }
#declare T = texture { gradient x texture_map { [0 pigment { rgb 1 }] } }
sphere { 0, 1 texture { T finish { phong 1 } } }
sphere { 0, 1 texture { T } texture { pigment { rgbt 1 } } }
sphere { 0, 1 texture { gradient x scale 2 } }

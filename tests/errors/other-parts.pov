#declare T = texture { pigment { rgb 1 } }
#declare C = rgb 1;
#declare I = interior { ior 1.5 }
#declare Red = rgb x;
sphere { 0, 1 material { T } }
sphere { 0, 1 pigment { T } }
sphere { 0, 1 finish { T } }
sphere { 0, 1 texture { C } }
sphere { 0, 1 texture { I } }
sphere { 0, 1 pigment { red } }
sphere { 0, 1 pigment { color "blue" } }
sphere { 0, 1 pigment { wood color_map { [rgb 1 0] [rgb 0 1] } } }
sphere { 0, 1 pigment { wood color_map { [0 0] [1 1] } } }
sphere { 0, 1 texture { texture_map { [0 T] [1 T] } } }
background { rgb 1 color }

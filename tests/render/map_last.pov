// A pattern's value of 1 is what most maps end with: there the last entry
// counts, though others have that value; between entries the first does.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { orthographic location -z*4 right 8*x up 6*y  look_at 0 }
light_source { -z*100 rgb 1 parallel point_at 0}
#macro M() box {<-.5,-.5,0><.5,.5,.1>
#end
#macro N(I, J) translate <I - 3.5, J> }
#end
#default { finish { ambient 0 diffuse 1 } }
M() pigment { function { 1 } pigment_map { [0 rgb 0][.5 rgb x][1 rgb x+y][1 rgb z] } } N(0, 1)
M() pigment { function { .5 } pigment_map { [0 rgb 0][.5 rgb x][.5 rgb x+y][.5 rgb z] } } N(1, 1)
M() texture { function { 1 } texture_map { [0 pigment { rgb x}][1 pigment {rgb y}] [1 pigment {rgb z}] }} N(2, 1)
M() texture { function { .5 } texture_map { [0 pigment { rgb x}][.5 pigment {rgb y}] [.5 pigment {rgb z}] }} N(3, 1)
M() pigment { rgb 1 } normal { function { 1 } normal_map { [0 gradient x 0] [1 gradient x .1] [1 gradient x 1]}} N(4, 1)
M() pigment { rgb 1 } normal { gradient x 0.5 slope_map {[0 <0,0>] [.2 <0,0>] [.2 <.5, 0>] [.5 <1,3>] [.5 <0, 1>]} translate x*.1} N(5, 1)
M() pigment { function { .5 } color_map { [0 rgb 0][.5 rgb x+y][.5 rgb y][.5 rgb z] } } N(6, 1)
M() pigment { function { .5 } color_map { [.5 rgb x] [.5 rgb y] [.7 rgb z]} } N(7, 1)
M() pigment { function { 1 } color_map { [0 rgb 0][1 rgb x+y][1 rgb z] } } N(0, -1)
M() pigment { function { .5 } color_map { [0 rgb 0][.5 rgb x+y][.5 rgb z][1 rgb x] } } N(1, -1)
M() pigment { function { 0 } color_map { [0 rgb x][0 rgb y][1 rgb x] } } N(2, -1)
M() pigment { mandel 10 color_map { [0 rgb 0][1 rgb x+y][1 rgb z] } scale 40 } N(3, -1)
M() pigment { function { 1 } color_map { [0 rgb 0][1 rgb x+y][1 rgb z][1 rgb x] } } N(4, -1)

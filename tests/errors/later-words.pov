#version 3.7;
camera { user_defined location { function { u } function { v } function { -2 } } }
sphere { 0, 1 }
lemon { 0, .3, y, .2, .7 pigment { rgb 1 } }
#declare A = array[] {1, <1, 2>, max(1, 2)};
#declare A = array mixed[2] {1, <1, 2>};
#declare (B, C) = M(3);
#declare { B, C } = array[2] {3, 4};
#declare D = spline { akima_spline 0, 0 1, x };
sphere { 0, 1 pigment { potential E threshold 1 } }
sphere { 0, 1 pigment { user_defined { function { x } } } }
sphere { 0, 1 pigment { gradient x color_map { blend_mode 1 [0 rgb 0] [1 rgb 1] } } }
isosurface { function { x } polarity on }
isosurface { function { x } potential on }
ovus { 1, .5 distance 2 }

#version 3.7;
#while I < 3 #end
#switch (3) case 1: #break #end
#declare F = function(a) { a > 0 ? a : 0 }
#declare G = function(a) { if (a > 0) { a } else { 0 } }
#declare V = <1, 0, 0>;
box { -1, 1 pigment { granit } }
box { -1, 1 pigment { V } }
box { -1, 1 pigment { checker, rgb 1, rgb 0 } }
box { -1, 1 pigment { checker { rgb 1 rgb 0 } } }
box { -1, 1 material { pigment { rgb 1 } } }
light_source { y, 1 spotlight { point_at 0 radius 10 } }
blob { sphere { 0, 1 } }
sphere_sweep { linear_spline 2 <0, 0, 0>, <1, 1, 1>, .2 }
lathe { linear_spline 3 <0, 0> <1, 1> <0, 2> <3, 3> }
#declare S = spline { linear_spline 0, 0, 1, y
sphere { S(.5), 1 }
box { -1, 1 pigment { rgb 1 } uv_map }
#declare Ball = sphere { 0, 1 }
Ball translate x

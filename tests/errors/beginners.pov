#version 3.7;
#include colors.inc
sphere { 0,0,0, 1 }
sphere { <0, 0, 0> pigment { rgb 1 } }
sphere { 0, 1, pigment { rgb 1 } }
sphere { 0, 1 pigment { rgb 1 0 0 } }
sphere { 0, 1 pigment { rgb (1, 0, 0) } }
sphere { 0, 1 rotate 20y }
sphere { 0, 1 rotate y 20 }
sphere { 0, 1 pigment { Red } }
sphere { 0, 1 texture { T_Wood1 } }
sphere { 0, 1 Blue }
camera { location look_at 0 }
Sphere { 0, 1 }
#macro Ball(R) sphere { 0, R } #end
Ball()
global_settings { light_mesh { samples 3 } }
global_settings { light_mesh { region { 0, 1 facter 2 } } }
sphere { 0, 1 pigment { image_map { pgn "a.png" } } }
sphere { 0, 1 pigment { image_map { png a.png } } }
sphere { 0, 1 pigment { gradient color_map { [0 rgb 1] } } }
sphere { 0, 1 finish { phong reflection .2 } }
sphere { 0, 1 translate }
lathe { linear_spline 5, <0, 0>, <1, 0>, <1, 1> pigment { rgb 1 } }

// light_group in a union: its lamp lights its own objects alone.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 6, -7> look_at 0 }
plane { y, 0 pigment { rgb 1 } }
light_source { <3,5,-4> rgb .2 }
union { light_group { light_source { <0,4,0> rgb x } sphere { 0,1 pigment { rgb 1 } } global_lights off } sphere { <2,1,0>,1 pigment { rgb 1 } } translate .5*x }

// An orthographic one from below, with right and up the other way round.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, -12, 0> up 6*z right -8*x look_at 0 }
light_source { <-6, -20, -9> rgb 1 }
plane { y, 1 pigment { checker rgb 1 rgb <.2, .6, .9> } }
cylinder { 0, 4*x, .4 pigment { rgb x } }
cylinder { 0, 3*z, .4 pigment { rgb z } }
text { ttf "cyrvetic.ttf", "Up", 1, 0 rotate 90*x pigment { rgb y } }

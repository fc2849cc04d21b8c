// A camera that looks straight along its sky, and says what is up and right.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 12, 0> up z right 4/3*x look_at 0 }
light_source { <-6, 20, -9> rgb 1 }
plane { y, 0 pigment { checker rgb 1 rgb <.2, .6, .9> } }
cylinder { 0, 4*x, .4 pigment { rgb x } }
cylinder { 0, 3*z, .4 pigment { rgb z } }
text { ttf "cyrvetic.ttf", "Up", 1, 0 rotate 90*x translate .5*y
    pigment { rgb y } }

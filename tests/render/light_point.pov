// Point lights: several, coloured, negative, shadowless, transformed; an
// object lit from behind.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -8> right 4/3*x look_at <0, .3, 0> angle 40 }
light_source { <-4, 3, -2>, rgb <.9, .3, .2> }
light_source { <0, 3, 0>, rgb <.2, .8, .3> rotate 30*z translate <4, 0, -2> }
light_source { <0, 5, 4>, rgb <.3, .4, .9> shadowless }
light_source { <1, .6, -2.5>, rgb -.25 }
sphere { <-1.2, .6, 0>, .6 pigment { rgb .9 } finish { phong .6 } }
box { <.5, .01, -.3>, <1.5, 1.2, .7> pigment { rgb .9 } rotate 20*y }
plane { y, 0 pigment { rgb .9 } }

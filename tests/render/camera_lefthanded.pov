// camera: a negative right mirrors the picture (right-handed coordinates),
// z is up, and a mirrored up.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <5, -6, 4> sky z up z right -4/3*x look_at <0, 0, .7> angle 40 }
light_source { <4, -8, 9>, rgb 1 }
background { rgb <.4, .5, .7> }
cylinder { 0, 3*x, .1 pigment { rgb <.9, .2, .2> } }
cylinder { 0, 3*y, .1 pigment { rgb <.2, .8, .2> } }
cylinder { 0, 2*z, .1 pigment { rgb <.2, .3, .9> } }
sphere { <1.2, 1.2, .5>, .5 pigment { rgb <.9, .8, .3> } }
plane { z, -.12 pigment { checker rgb .5, rgb .7 translate .2 } }

// camera: angle, look_at, given in another order, and sky tilting it.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { angle 70 location <2, 3, -5> right 4/3*x sky <.3, 1, 0>
    look_at <0, .8, 0> }
light_source { <4, 8, -6>, rgb 1 }
background { rgb <.4, .5, .7> }
box { -1, 1 pigment { checker rgb <.9, .4, .3>, rgb .9 scale .49 translate .13 }
    translate <0, 1.01, 0> }
sphere { <1.8, .6, -.8>, .6 pigment { rgb <.3, .7, .4> } }
plane { y, 0 pigment { checker rgb .5, rgb .7 translate .2 } }

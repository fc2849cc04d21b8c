// orthographic camera: sized by the lengths of right and up.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <-3, 3, -6> right 7*x up 4*y look_at <0, .5, 0> }
light_source { <4, 8, -6>, rgb 1 }
background { rgb <.4, .5, .7> }
box { -1, 1 pigment { checker rgb <.9, .4, .3>, rgb .9 scale .49 translate .13 }
    translate <0, 1.01, 0> }
sphere { <1.8, .6, -.8>, .6 pigment { rgb <.3, .7, .4> } }
plane { y, 0 pigment { checker rgb .5, rgb .7 translate .2 } }

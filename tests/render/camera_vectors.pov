// camera: direction, right and up given, uneven and not at right angles, no
// look_at, then rotated and translated.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> direction <.1, 0, 1.4> right <1.5, .2, 0>
    up <.1, 1.2, 0> rotate <15, 20, 5> translate <0, .8, 0> }
light_source { <-4, 8, -6>, rgb 1 }
background { rgb <.4, .5, .7> }
box { -1, 1 pigment { checker rgb <.9, .4, .3>, rgb .9 scale .49 translate .13 }
    translate <0, 1.01, 0> }
sphere { <1.8, .6, -.8>, .6 pigment { rgb <.3, .7, .4> } }
plane { y, 0 pigment { checker rgb .5, rgb .7 translate .2 } }

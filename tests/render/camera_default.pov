// No camera at all: at the origin, looking along +z, 1.33 wide. A light with no
// colour is black.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
light_source { <4, 6, -3> }
light_source { <-4, 6, -3>, rgb 1 }
background { rgb <.4, .5, .7> }
box { -1, 1 pigment { checker rgb <.9, .4, .3>, rgb .9 scale .49 translate .13 }
    rotate <10, 30, 0> translate <-.5, .2, 5> }
sphere { <1.3, -.4, 4>, .6 pigment { rgb <.3, .7, .4> } }
plane { y, -1.6 pigment { checker rgb .5, rgb .7 translate .2 } }

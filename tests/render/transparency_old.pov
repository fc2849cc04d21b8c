// Before version 3.7 a filter leaves more of the surface's own light, by its
// brightest colour; so it does in layers.
// compare: exact
#version 3.6;
global_settings { assumed_gamma 1 max_trace_level 10 }
camera { location <0, 2, -7> right 4/3*x look_at <0, 1, 0> angle 45 }
light_source { <-4, 7, -8>, rgb 1 }
background { rgb <.2, .25, .2> }
#declare F = finish { ambient .15 diffuse .7 }
box { <-3, .1, 0>, <-1.8, 1.3, 1> pigment { rgb <.2, .9, .5> filter .9 }
    finish { F } }
sphere { <-.9, .8, 0>, .7 pigment { rgb <.7, .3, .2> filter .5 transmit .3 }
    finish { F emission .1 phong .4 } }
sphere { <.8, .8, 0>, .7 texture { pigment { rgb <.2, .5, .8> } }
    texture { pigment { rgbf <.4, .6, .2, .8> } finish { F } } }
sphere { <2.4, .8, 0>, .7 pigment { rgbt <.7, .3, .2, .6> } finish { F } }
plane { y, 0 pigment { checker rgb .8, rgb .5 } }

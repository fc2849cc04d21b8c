// Functions of patterns, pigments and functions.inc; as patterns and normals;
// the patterns pigment_pattern and object.
// compare: exact
#version 3.7;
#include "functions.inc"
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -5> right 4*x up 3*y }
light_source { <-3, 4, -6>, 1 }
#default { pigment { rgb .9 } finish { ambient .3 diffuse .7 } }
#declare Rings = function { pattern { wood scale .3 rotate <20, 30, 0> } }
#declare Ramp = function { pigment { gradient x color_map { [0 rgb <1, .2, .1>] [1 rgbft <0, .5, 1, .3, .1>] } } }
#declare Mix = function(x, y, z, k) { f_sphere(x, y, z, .5)*k + Ramp(x, y, z).green - Ramp(x, y, z).transmit }
sphere { <-1.5, 1, 0>, .48 pigment { function { sin(x*7)*cos(y*9) + x*.3 }
    color_map { [0 rgb 0] [.5 rgb <1, .5, 0>] [1 rgb 1] } rotate 20*z } }
sphere { <-.5, 1, 0>, .48 pigment { function { abs(x)*3 + (y > 0)*.4 - 5 } scale <.4, .8, .4> frequency 2 }
    normal { function { sin(x*22) } .5 } }
sphere { <.5, 1, 0>, .48 pigment { object { union { sphere { <.5, 1, -.5>, .3 } box { <.4, .9, -1>, <1, 1.1, 1> } }
    rgb <1, .2, .1>, rgb <.1, .6, .3> } } }
sphere { <1.5, 1, 0>, .48 texture { object { sphere { <1.5, 1, -.5>, .3 } texture { pigment { rgb 1 } }
    texture { pigment { checker scale .1 } } } } }
sphere { <-1.5, 0, 0>, .48 pigment { pigment_pattern { checker rgb <1, 0, 0> rgb <0, 1, 0> scale .2 }
    color_map { [0 rgb 0] [.4 rgb <1, .5, 0>] [1 rgb 1] } rotate 20*z } }
sphere { <-.5, 0, 0>, .48 pigment { average pigment_map { [function { Mix(x, y, z, .5) }
    color_map { [0 rgb <1, 0, 0>] [1 rgb <0, 0, 1>] }] [1 checker scale .3] } rotate 20*z scale .6 } }
sphere { <.5, 0, 0>, .48 pigment { function { Rings(x, y, z)*.8 + f_checker(x*5, y*5, z*5)*.2 } } }
sphere { <1.5, 0, 0>, .48 pigment { function { f_rounded_box(x - 1.5, y, z + .4, .1, .3, .2, .3)*3 } } }
sphere { <-1.5, -1, 0>, .48 pigment { function { f_torus(x + 1.5, y + 1, z + .4, .25, .1)*4 } } }
sphere { <-.5, -1, 0>, .48 pigment { function { f_th(x + .5, y + 1, z)/6 + f_ph(x + .5, y + 1, z) } } }
sphere { <.5, -1, 0>, .48 pigment { function { f_ellipsoid(x - .5, y + 1, z, 1, 3, 1) } frequency 3 } }
sphere { <1.5, -1, 0>, .48 pigment { rgb Ramp(.3, 0, 0)*1 } normal { object { sphere { <1.5, -1, -.5>, .3 }
    normal { gradient x scale .1 } normal { gradient y scale .1 } } } }

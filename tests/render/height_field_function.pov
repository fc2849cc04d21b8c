// height_field from functions: formulas, above 1, pigments, patterns.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5.5, -6> right 4/3*x look_at <0, 0, .3> angle 42 }
light_source { <-8, 9, -4>, rgb 1 }
background { rgb <.25, .3, .4> }
#default { pigment { rgb <.8, .7, .5> } }
height_field { function 20, 30 { x*y } translate <-1.6, 0, 1> }
#declare Hill = function(r) { exp(-r*r) }
height_field { function 40 40 { .8*Hill(4*(x - .4)) + y/5 } smooth
    translate <-.5, 0, 1> pigment { gradient y scale .1 } }
height_field { function 50, 40 { x*2 + z } smooth scale <1, .4, 1>
    translate <.6, 0, 1> finish { phong .6 phong_size 30 } }
height_field { function 33, 17 { pigment { gradient x
        color_map { [0 rgb <1, 0, 0>] [.5 rgb <0, 0, 1>] [1 rgb <0, 1, 0>] }
        rotate 30*z } } smooth
    translate <-1.6, -.2, -.3> }
height_field { function 60, 60 { pattern { spherical scale .6 translate <.7, .2, 0> } }
    water_level .3 scale <1, .7, 1> translate <-.5, 0, -.3> }
height_field { function 25, 25 { pattern { radial frequency 3 translate <.5, 0, .1> rotate 90*x } }
    translate <.6, 0, -.3> }
difference {
    box { <.01, -.3, .01>, <.99, .8, .99> }
    height_field { function 30, 30 { select(x - .5, .2, y) } translate -.2*y }
    translate <-.5, 0, -1.6>
}

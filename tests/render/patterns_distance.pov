// spherical, cylindrical, planar and boxed: from 1 in the middle to 0 at
// distance 1, with frequency, phase and waves, as pigments and as a normal.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -7> right 4/3*x look_at 0 angle 45 }
light_source { <-3, 5, -9>, rgb 1 }
background { rgb .15 }
#declare Map = color_map {
    [0 rgb <.1, .2, .6>] [.4 rgb <.9, .8, .3>] [.8 rgb <.8, .2, .1>] [1 rgb .95] }
#macro Pair(Column, Row, P)
    union {
        box { <-1, -.85, .6>, <1, .85, .8> }
        sphere { <0, 0, .2>, .6 }
        pigment { P } translate <2.3*Column - 2.3, .95 - 1.9*Row, 0>
    }
#end
Pair(0, 0, pigment { spherical color_map { Map } scale 1.3 })
Pair(1, 0, pigment { cylindrical color_map { Map } frequency 2 phase .3 })
Pair(2, 0, pigment { planar color_map { Map } rotate 30*z scale .8 })
Pair(0, 1, pigment { boxed color_map { Map } sine_wave frequency 3 })
Pair(1, 1, pigment { spherical translate .3*y poly_wave 2 scale .9 })
box { <1.3, -1.8, .6>, <3.3, -.1, .8> pigment { rgb .8 }
    normal { boxed 1 frequency 2 triangle_wave scale .5
        translate <2.3, -.9, .6> } }

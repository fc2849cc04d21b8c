// radial, onion, leopard, wood and marble without turbulence, gradient along
// a slanted direction, each on a slab and a sphere.
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
Pair(0, 0, pigment { radial color_map { Map } frequency 3 rotate 90*x })
Pair(1, 0, pigment { onion color_map { Map } scale .4 translate <.1, .2, 0> })
Pair(2, 0, pigment { leopard color_map { Map } scale .12 })
Pair(0, 1, pigment { wood color_map { Map } scale .3 rotate 20*x })
Pair(1, 1, pigment { marble color_map { Map } scale .5 rotate 30*z })
Pair(2, 1, pigment { gradient <1, 2, -.5> color_map { Map } scale .7 })

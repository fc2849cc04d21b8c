// frequency and phase on patterns whose value is not a ramp: onion, wood,
// radial, leopard; negative frequency; default black and white map.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -5> right 4*x up 3*y }
light_source { <0, 0, -100>, rgb 1 parallel point_at 0 }
#default { finish { ambient 0 diffuse 1 } }
#macro Tile(Column, Row, P)
    box { <-.64, -.72, 0>, <.64, .72, .1> pigment { P translate .02 }
        translate <1.33*Column - 1.33, .75 - 1.5*Row, 0> }
#end
Tile(0, 0, pigment { onion frequency 3 })
Tile(1, 0, pigment { wood frequency 4 phase .3 sine_wave })
Tile(2, 0, pigment { radial frequency 6 phase .2 rotate 90*x })
Tile(0, 1, pigment { leopard frequency 2 phase .5 triangle_wave scale .1 })
Tile(1, 1, pigment { onion frequency -2 phase .1 color_map {
    [0 rgb <.9, .2, .1>] [1 rgb <.9, .9, .5>] } })
Tile(2, 1, pigment { marble frequency 3 color_map {
    [0 rgb <.1, .3, .3>] [1 rgb <.6, .9, .5>] } rotate 45*z })

// quilted, spiral1 and spiral2, as pigments and as normals.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -z right 4*x up 3*y }
#default { finish { ambient 1 diffuse 0 } }
#declare Map = color_map {
    [0 rgb <.1, .2, .6>] [.3 rgb <.9, .8, .3>] [.7 rgb <.8, .2, .1>] [1 rgb .95] }
#macro Tile(Column, Row, P)
    box { <-1.7, -1.7, 0>, <1.7, 1.7, .1> pigment { P color_map { Map } } scale .28
        translate <Column - 1.5, 1 - Row, 0> }
#end
Tile(0, 0, pigment { quilted })
Tile(1, 0, pigment { quilted control0 .3 control1 .8 rotate 30*x })
Tile(2, 0, pigment { spiral1 3 })
Tile(3, 0, pigment { spiral1 -2 scale .6 rotate 70*x })
Tile(0, 1, pigment { spiral1 1 sine_wave frequency 2 })
Tile(1, 1, pigment { spiral2 3 })
light_source { <-9, 9, -20>, rgb 1 }
#default { finish { ambient 0 diffuse 1 } pigment { rgb .9 } }
box { <-1, -.5, 0>, <0, .5, .1> normal { quilted 1.5 scale .4 } }
box { <0, -.5, 0>, <1, .5, .1> normal { quilted .7 control0 0 control1 .5
    scale .3 rotate 20 } }
box { <1, -.5, 0>, <2, .5, .1> normal { spiral2 4 .5 scale .3
    translate <1.5, 0, 0> } }
box { <-2, -1.5, 0>, <2, -.5, .1> normal { mandel 20 .5 scale .3
    translate <.3, -1, 0> } }

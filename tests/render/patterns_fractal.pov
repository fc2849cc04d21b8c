// mandel, julia and magnet: exteriors, interiors and exponents.
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
Tile(0, 0, pigment { mandel 12 })
Tile(1, 0, pigment { mandel 20 exponent 3 interior 1, .7 })
Tile(2, 0, pigment { mandel 15 exterior 2, .1 interior 2, .3 })
Tile(3, 0, pigment { mandel 15 exterior 7, 4 interior 3, .5 })
Tile(0, 1, pigment { julia <.353, .288>, 30 interior 1, 1 })
Tile(1, 1, pigment { julia <-.5, .5> 12 exponent 4 exterior 8, 3 })
Tile(2, 1, pigment { julia <-.7, .2> 20 exterior 4, .05 interior 5, 2 })
Tile(3, 1, pigment { mandel 12 exterior 0, .4 interior 0, .8 })
Tile(0, 2, pigment { mandel 12 exterior 3, .3 interior 4, .5 scale .7 })
Tile(1, 2, pigment { mandel 12 exterior 5, .02 frequency 2 phase .3 })
Tile(2, 2, pigment { mandel 12 exterior 6, .1 triangle_wave rotate 30*z })
Tile(3, 2, pigment { magnet 1 mandel 20 exterior 2, .1 interior 1, .5 translate -x })
box { <1.5, -1.5, -.1>, <2, -1, .1> pigment { magnet 2 mandel 20 interior 5, .1 color_map { Map } scale .2 translate <1.6, -1.2, 0> } }
box { <1.5, -1, -.1>, <2, -.5, .1> pigment { magnet 1 julia <1.5, .7>, 30 interior 1, 1 color_map { Map } scale .1 translate <1.7, -.7, 0> } }
box { <1, -1, -.1>, <1.5, -.5, .1> pigment { magnet 2 julia <.5, .7> 30 exterior 8, 3 color_map { Map } scale .1 translate <1.2, -.7, 0> } }
box { <1.5, -.5, -.1>, <2, 0, .1> pigment { mandel 15 interior 6, 3 color_map { Map } scale .15 translate <1.8, -.25, 0> } }

// Pictures by functions; a vector before the file; palette entries that let
// light pass; a declared texture_map.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -5> right 4*x up 3*y }
light_source { <-5, 8, -16>, 1 }
#default { finish { ambient .5 diffuse .5 } }
plane { z, 2 pigment { checker rgb .2 rgb .9 scale .3 } }
#declare Bands = texture_map { [0 pigment { rgb x }]
    [.5 pigment { rgb y } finish { phong 1 }] [1 pigment { rgb z }] }
#macro Card(P) box { 0, <.9, .9, .1> texture { P } } #end
object { Card(texture { pigment { image_map {
    function 16, 12 { pigment { checker rgb x rgbt <0, 1, 1, .6> scale .15 } } }
    } }) translate <-1.9, .1, 0> }
object { Card(texture { pigment { image_map {
    function 9, 9 { x * y * 1.5 } interpolate 2 } } })
    translate <-.9, .1, 0> }
object { Card(texture { pigment { image_map { <1, -1, 0> png "parts/flag.png" }
    } }) translate <.1, .1, 0> }
object { Card(texture { pigment { image_map { <1, 0, -1> png "parts/flag.png" }
    } }) translate <1.1, .1, 0> }
object { Card(texture { pigment { image_map { png "parts/heights_palette.png"
    filter 1 .9 transmit 2, .5 transmit 0 .2 interpolate 2 } } })
    translate <-1.9, -.9, 0> }
object { Card(texture { gradient y texture_map { Bands } })
    translate <-.9, -.9, 0> }
object { Card(texture { pigment { image_map {
    function 8, 8 { pattern { bozo scale .3 } } } } })
    translate <.1, -.9, 0> }

// square, triangular and cubic, with and without colours; image_pattern.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4, -5> look_at 0 angle 45 }
light_source { <-5, 8, -6>, 1 }
#default { finish { ambient .5 } }
#macro Tile(X, Z, P)
    box { <-.45, -.1, -.45>, <.45, 0, .45> pigment { P scale .2 rotate 9*y }
        translate <X, 0, Z> }
#end
Tile(-1.5, .5, pigment { square }) Tile(-.5, .5, pigment { triangular })
Tile(-1.5, -.5, pigment { square rgb 0 rgb .3 rgb .6 rgb 1 })
Tile(-.5, -.5, pigment { triangular pigment { rgb x } pigment { checker }
    pigment { rgb y } pigment { rgb z } pigment { rgb 1 } pigment { rgb .5 } })
sphere { <.5, 0, .5>, .5 pigment { cubic rotate 20 translate <.5, 0, .5> } }
sphere { <.5, 0, -.5>, .5 pigment { cubic rgb 0 rgb .2 rgb .4 rgb .6 rgb .8
    rgb 1 rotate 20 translate <.5, 0, -.5> } }
box { <1, -.1, -1>, <2, 0, 1> pigment { image_pattern { png "parts/flag.png"
    interpolate 2 } color_map { [0 rgb x] [1 rgb z] } rotate 90*x } }

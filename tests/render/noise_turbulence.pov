// turbulence on wood, marble, gradient and onion; a vector of turbulence;
// octaves, omega and lambda; the warp that does the same.
// compare: exact
// options: +W320 +H240
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -5> right 4*x up 3*y }
light_source { <0, 0, -100>, rgb 1 parallel point_at 0 }
#default { finish { ambient 0 diffuse 1 } }
#declare Map = color_map { [0 rgb <.5, .25, .1>] [.7 rgb <.9, .7, .4>] [1 rgb 1] }
#macro Tile(Column, Row, P)
    box { <-.67, -.75, 0>, <.67, .75, .1> pigment { P color_map { Map } }
        translate <1.333*Column - 1.333, .75 - 1.5*Row, 0> }
#end
Tile(0, 0, pigment { wood turbulence .15 scale .09 })
Tile(1, 0, pigment { marble turbulence .2 scale .09 })
Tile(2, 0, pigment { gradient x turbulence <.2, 0, .2> scale .09 })
Tile(0, 1, pigment { marble turbulence .4 octaves 1 scale .09 })
Tile(1, 1, pigment { marble turbulence .2 octaves 8 lambda 3 omega .8 scale .09 })
Tile(2, 1, pigment { onion warp { turbulence .2 octaves 4 } scale .09 })

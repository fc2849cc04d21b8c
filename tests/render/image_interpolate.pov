// image_map with interpolate 2 (bilinear), 3 (bicubic) and 4 (normalised
// distance), beside the same without, from a PNG and from a text PPM.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -5> right 4*x up 3*y }
light_source { <0, 0, -100>, rgb 1 parallel point_at 0 }
#default { finish { ambient 0 diffuse 1 } }
#macro Tile(Column, Row, P)
    box { <0, 0, 0>, <1, 1, .1> pigment { P }
        scale <1.9, 1.4, 1> translate <1.95*Column - 1.92, .06 - 1.49*Row, 0> }
#end
Tile(0, 0, pigment { image_map { png "parts/flag.png" interpolate 2 } })
Tile(1, 0, pigment { image_map { png "parts/flag.png" once interpolate 4 } })
Tile(0, 1, pigment { image_map { ppm "parts/tiles.ppm" interpolate 2 } })
Tile(1, 1, pigment { image_map { ppm "parts/tiles.ppm" } })
box { -.5, .5 pigment { image_map { png "parts/flag.png" interpolate 3 } translate <.2, .4, 0> } translate -z }
box { -.5, .5 pigment { image_map { png "parts/flag.png" once interpolate 3 } translate -.5 } rotate 45*z scale .6 translate <-1, .75, -1> }

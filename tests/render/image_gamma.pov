// The colours of an image are decoded for assumed_gamma; a gamma given with
// the image overrides what the file says.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 2.2 }
camera { orthographic location <0, 0, -5> right 4*x up 3*y }
light_source { <0, 0, -100>, rgb 1 parallel point_at 0 }
#default { finish { ambient 0 diffuse 1 } }
#macro Tile(Column, Row, P)
    box { <0, 0, 0>, <1, 1, .1> pigment { P }
        scale <1.9, 1.4, 1> translate <1.95*Column - 1.92, .06 - 1.49*Row, 0> }
#end
Tile(0, 0, pigment { image_map { png "parts/flag.png" } })
Tile(1, 0, pigment { image_map { png "parts/flag.png" gamma 1 } })
Tile(0, 1, pigment { image_map { ppm "parts/tiles.ppm" } })
Tile(1, 1, pigment { image_map { ppm "parts/tiles.ppm" gamma 2.2 } })

// image_map, planar: repeated, once, turned; transparent outside of once.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -5> right 4*x up 3*y }
light_source { <0, 0, -100>, rgb 1 parallel point_at 0 }
background { rgb <.8, .5, .8> }
#default { finish { ambient 0 diffuse 1 } }
box { <-1.9, .1, 0>, <-.1, 1.4, .1>
    pigment { image_map { png "parts/flag.png" } scale .7 translate .11 } }
box { <.1, .1, 0>, <1.9, 1.4, .1>
    pigment { image_map { png "parts/flag.png" once } scale <1.2, .9, 1>
        translate <.4, .3, 0> } }
box { <-1.9, -1.4, 0>, <-.1, -.1, .1>
    pigment { image_map { png "parts/flag.png" } rotate 30*z scale .9 } }
box { <-.7, -.65, -.7>, <.7, .65, .7>
    pigment { image_map { png "parts/flag.png" map_type 0 } scale .63 translate .11 }
    rotate <25, 35, 0> translate <1, -.75, 1> }

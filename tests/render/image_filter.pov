// image_map with filter all, transmit all, and one entry by its number, over
// a checkered wall.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -5> right 4*x up 3*y }
light_source { <0, 0, -100>, rgb 1 shadowless parallel point_at 0 }
#default { finish { ambient 0 diffuse 1 } }
box { 0, <1, 1, .1> scale <1.2, 2.4, 1> translate <-1.9, -1.2, 0>
    pigment { image_map { png "parts/flag.png" filter all .7 }
        scale .7 translate <.0037, .0053, 0> } }
box { 0, <1, 1, .1> scale <1.2, 2.4, 1> translate <-.6, -1.2, 0>
    pigment { image_map { png "parts/flag.png" transmit all .5 }
        scale .7 translate <.0037, .0053, 0> } }
box { 0, <1, 1, .1> scale <1.2, 2.4, 1> translate <.7, -1.2, 0>
    pigment { image_map { png "parts/alpha.png" }
        scale .7 translate <.0037, .0053, 0> } }
plane { -z, -1 pigment { checker rgb 1, rgb <.6, .7, .8> scale .31 } }

// uv_mapping in what pigment_map, lists, pigment_pattern, normal_map and
// texture_map are made of: each of the surface's own coordinates.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -8> right 4/3*x look_at 0 angle 44 }
light_source { <-6, 8, -6> rgb 1 }
#declare Tiles = pigment { uv_mapping checker rgb 1 rgb <.2, .3, .8> scale .1 }
#declare Ribs = normal { uv_mapping gradient x 2 scale .1 }
sphere { 0, 1 pigment { checker pigment { Tiles } pigment { rgb x } scale .5 } translate <-2.2, 1.2, 0> }
sphere { 0, 1 pigment { gradient y pigment_map { [.5 Tiles] [.5 rgb x] } scale .5 } translate <0, 1.2, 0> }
sphere { 0, 1 pigment { pigment_pattern { Tiles } color_map { [0 rgb x] [1 rgb y] } } translate <2.2, 1.2, 0> }
sphere { 0, 1 pigment { rgb 1 } normal { gradient y normal_map { [.5 Ribs] [.5 bumps 0] } scale .5 } translate <-2.2, -1.2, 0> }
torus { .7, .3 texture { uv_mapping gradient y texture_map { [.5 pigment { Tiles }] [.5 pigment { rgb x }] } scale .5 } rotate -60*x translate -1.2*y }
sphere { 0, 1 pigment { average pigment_map { [Tiles] [2 rgb y] } } normal { average normal_map { [Ribs] [bumps scale .1] } } translate <2.2, -1.2, 0> }

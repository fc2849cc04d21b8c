// crackle: plain, form, metric and solid.
// compare: exact
// options: +W320 +H240
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -5> right 4*x up 3*y }
light_source { <0, 0, -100>, rgb 1 parallel point_at 0 }
#default { finish { ambient 0 diffuse 1 } }
#declare Map = color_map { [0 rgb <.1, 0, .2>] [.5 rgb <.9, .5, .2>] [1 rgb 1] }
box { <-2, 0, 0>, <0, 1.5, .1> pigment { crackle color_map { Map } scale .06 } }
box { <0, 0, 0>, <2, 1.5, .1>
    pigment { crackle form <-1, 1, 0> color_map { Map } scale .06 } }
box { <-2, -1.5, 0>, <0, 0, .1>
    pigment { crackle metric 1 color_map { Map } scale .06 } }
box { <0, -1.5, 0>, <2, 0, .1>
    pigment { crackle solid color_map { Map } scale .025 } }

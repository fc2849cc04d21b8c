// cells: plain, through a map with steps, as bumps.
// compare: noise
// options: +W320 +H240
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -5> right 4*x up 3*y }
light_source { <0, 0, -100>, rgb 1 parallel point_at 0 }
#default { finish { ambient 0 diffuse 1 } }
#declare Map = color_map { [0 rgb <.1, 0, .2>] [.5 rgb <.9, .5, .2>] [1 rgb 1] }
box { <-2, 0, 0>, <0, 1.5, .1> pigment { cells scale .025 } }
box { <0, 0, 0>, <2, 1.5, .1> pigment { cells color_map { Map } scale .02 } }
box { <-2, -1.5, 0>, <0, 0, .1>
    pigment { cells triangle_wave color_map { Map } scale <.02, .06, .02> rotate 30*z } }
box { <0, -1.5, 0>, <2, 0, .1> pigment { cells color_map { [.7 rgb 1] [.7 rgb x] } scale .025 } }

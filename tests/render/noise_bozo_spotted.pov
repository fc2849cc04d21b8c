// bozo and spotted, with a map and without, small enough that a region shows
// many spots.
// compare: exact
// options: +W320 +H240
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -5> right 4*x up 3*y }
light_source { <0, 0, -100>, rgb 1 parallel point_at 0 }
#default { finish { ambient 0 diffuse 1 } }
box { <-2, 0, 0>, <2, 1.5, .1> pigment { bozo
    color_map { [0 rgb <.1, .2, .6>] [.5 rgb <.9, .6, .2>] [1 rgb 1] } scale .05 } }
box { <-2, -1.5, 0>, <0, 0, .1> pigment { spotted scale .05 } }
box { <0, -1.5, 0>, <2, 0, .1> pigment { bozo
    color_map { [.45 rgb <.2, .5, .2>] [.45 rgb <.9, .9, .5>] } scale .04 } }

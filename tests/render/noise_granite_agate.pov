// granite and agate (with agate_turb), small enough to fill a region.
// compare: exact
// options: +W320 +H240
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -5> right 4*x up 3*y }
light_source { <0, 0, -100>, rgb 1 parallel point_at 0 }
#default { finish { ambient 0 diffuse 1 } }
box { <-2, 0, 0>, <2, 1.5, .1> pigment { granite
    color_map { [0 rgb <.2, .1, .1>] [.4 rgb <.8, .5, .4>] [1 rgb 1] } scale .08 } }
box { <-2, -1.5, 0>, <0, 0, .1> pigment { agate scale .035
    color_map { [0 rgb <.1, .2, .3>] [1 rgb <.9, .8, .6>] } } }
box { <0, -1.5, 0>, <2, 0, .1> pigment { agate agate_turb .4 scale .035
    color_map { [0 rgb <.3, .1, .1>] [1 rgb <.7, .9, .6>] } } }

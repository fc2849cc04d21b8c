// Gamma: an unusual assumed_gamma, and only the first one counts.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1.5 }
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -5> right 4*x up 3*y }
light_source { <-2, 3, -9>, rgb .8 }
light_source { <4, 2, -9>, rgb .3 }
background { rgb <.2, .5, .7> }
sphere { <-1, .6, 0>, .8 pigment { rgb <.8, .4, .2> } finish { ambient .1 phong .5 } }
box { <.2, -.1, 0>, <1.8, 1.3, .1>
    pigment { gradient x color_map { [0 rgb 0] [1 rgb 1] } scale 1.61 translate .19*x }
    finish { ambient 1 diffuse 0 } }
box { <-1.8, -1.3, 0>, <-.1, -.4, .1> pigment { rgbt <.9, .2, .2, .5> } }
box { <.2, -1.3, 0>, <1.8, -.3, .1>
    pigment { image_map { png "parts/flag.png" } scale .8 translate .1 }
    finish { ambient 1 diffuse 0 } }

// Gamma: srgb, srgbf and srgbt colours are decoded, in lights too.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -5> right 4*x up 3*y }
light_source { <0, 0, -100>, srgb <.9, .95, 1> parallel point_at 0 }
background { srgb <.5, .6, .7> }
#default { finish { ambient 0 diffuse 1 } }
#declare C = srgb <.2, .4, .8>;
box { <-1.9, .1, 0>, <-.7, 1.4, .1> pigment { srgb <.8, .4, .2> } }
box { <-.6, .1, 0>, <.6, 1.4, .1> pigment { C } }
box { <.7, .1, 0>, <1.9, 1.4, .1> pigment { srgb .25*2 } }
box { <-1.9, -1.4, 0>, <-.7, -.1, .1> pigment { srgbf <.8, .4, .2, .5> } }
box { <-.6, -1.4, 0>, <.6, -.1, .1> pigment { srgbt <.8, .4, .2, .5> } }
box { <.7, -1.4, 0>, <1.9, -.1, .1> pigment { gradient x color_map {
    [0 srgb <.1, .1, .5>] [1 srgb <.9, .8, .3>] } scale 1.3 translate .65*x } }

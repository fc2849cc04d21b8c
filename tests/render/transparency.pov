// filter colours what is behind, transmit only weakens it; rgbf, rgbt, rgbft
// and the keywords; coloured shadows.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 10 }
camera { location <0, 4, -8> right 4/3*x look_at <0, .9, 0> angle 42 }
light_source { <-4, 9, -5>, rgb 1 }
background { rgb <.5, .6, .8> }
box { <-3.4, 0, -.4>, <-2, 1.8, -.3> pigment { rgbf <.9, .3, .2, .8> } }
box { <-1.6, 0, -.4>, <-.2, 1.8, -.3> pigment { rgbt <.9, .3, .2, .8> } }
box { <.2, 0, -.4>, <1.6, 1.8, -.3> pigment { rgbft <.3, .9, .4, .5, .3> } }
box { <2, 0, -.4>, <3.4, 1.8, -.3>
    pigment { color red .3 green .5 blue .9 filter .4 transmit .2 }
    finish { phong .6 } }
sphere { <0, .5, 1.5>, .5 pigment { rgb <.9, .8, .2> } }
plane { y, -.02 pigment { checker rgb .9, rgb .5 scale .7 translate .2 } }

// Cones: cut, pointed, open, upside down, and of two equal radii.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4.5, -8> right 4/3*x look_at <0, .7, 0> angle 45 }
light_source { <6, 9, -7>, rgb 1 }
background { rgb <.15, .25, .2> }
cone { <-2.8, 0, 0>, .8, <-2.8, 1.8, 0>, .3 pigment { rgb <.9, .5, .3> } }
cone { <-1, 0, .2>, .7, <-.8, 2, 0>, 0 pigment { rgb <.4, .7, .9> } }
cone { <.8, 0, 0>, .3, <.8, 1.5, 0>, .8 open pigment { rgb <.8, .8, .3> } }
cone { <2.7, 1.6, 0>, .2, <2.4, 0, -.3>, .8 open pigment { rgb <.7, .4, .8> } }
cone { <-1, .31, -2>, .3, <1, .31, -2>, .3 pigment { rgb <.5, .9, .5> } }
plane { y, -.01 pigment { rgb .65 } }

// Boxes: corners in any order, rotated, skewed by scale after rotate.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <3, 4, -7> right 4/3*x look_at <0, .3, 0> angle 45 }
light_source { <5, 9, -6>, rgb 1 }
background { rgb <.2, .2, .3> }
box { <-3, 0, -.5>, <-1.6, 1.3, 1> pigment { rgb <.9, .4, .2> } }
box { <.7, 1.4, .7>, <-.7, .01, -.7> rotate 30*y translate <.1, 0, -.3>
    pigment { rgb <.3, .7, .9> } }
box { -1, 1 rotate 45*z scale <.7, 1.2, .7> translate <2.3, 1.7, .8>
    pigment { rgb <.6, .9, .3> } }
box { <-6, -.3, -4>, <6, -.01, 5> pigment { rgb .6 } }

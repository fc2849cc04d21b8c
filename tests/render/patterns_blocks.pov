// checker, hexagon and brick, with colours, with defaults, and with mortar
// and brick_size.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3.2, -6> right 4/3*x look_at <0, 1.2, 0> angle 55 }
light_source { <-3, 6, -6>, rgb 1.2 }
background { rgb .2 }
plane { y, 0
    pigment { hexagon rgb <.9, .4, .3>, rgb <.9, .9, .6>, rgb <.3, .5, .7>
        scale .5 translate <.13, 0, .21> } }
box { <-3.2, .02, .5>, <-1.2, 2, 2>
    pigment { brick rgb .8, rgb <.7, .2, .1> mortar .06
        brick_size <.7, .3, .35> translate <.11, .07, .13> } }
box { <-.9, .02, 1>, <.9, 2, 2>
    pigment { checker rgb <.2, .6, .3>, rgb <.9, .9, .7> scale .37
        translate .09 rotate 20*y } }
box { <1.2, .02, .5>, <3.2, 2, 2>
    pigment { brick scale .1 translate <.012, .023, .037> } }
sphere { <0, .6, -.8>, .6 pigment { checker scale .21 translate .05 } }

// polygon: convex, with a notch, with a hole (a second ring), and tilted.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -7> right 4/3*x look_at <0, 1, 0> angle 45 }
light_source { <-4, 7, -8>, rgb 1 }
background { rgb <.2, .25, .2> }
polygon { 4, <-3, .1>, <-1.6, .3>, <-1.3, 1.9>, <-2.7, 1.6>
    pigment { rgb <.9, .5, .2> } }
polygon { 7, <-1, 0>, <1, 0>, <1, 2>, <.1, .6>, <-.9, 1.8>, <-1.1, .9>, <-1, 0>
    pigment { rgb <.3, .8, .7> } translate .2*z }
polygon { 10,
    <0, 0>, <2, 0>, <2, 2>, <0, 2>, <0, 0>,
    <.5, .5>, <1.6, .6>, <1.2, 1.6>, <.4, 1.2>, <.5, .5>
    rotate <35, -30, 10> translate <1.2, .2, 0> pigment { rgb <.6, .5, .95> } }
plane { y, -.3 pigment { rgb .6 } }

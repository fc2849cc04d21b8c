// Tori: lying, standing, tilted, spindle (the tube wider than the ring), and
// seen through the hole.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4, -8> right 4/3*x look_at <0, .6, 0> angle 45 }
light_source { <-6, 9, -7>, rgb 1 }
background { rgb <.2, .2, .3> }
torus { 1, .3 translate <-2.4, .31, 0> pigment { rgb <.9, .6, .2> } }
torus { .8, .2 rotate 90*x translate <-.2, 1, .8> pigment { rgb <.3, .7, .9> } }
torus { .4, .5 translate <2.4, .51, .6> pigment { rgb <.8, .3, .4> } }
torus { .7, .15 rotate <60, 30, 0> scale <1, .6, 1> translate <1, .7, -1.2>
    pigment { rgb <.5, .9, .4> } }
plane { y, -.01 pigment { rgb .65 } }

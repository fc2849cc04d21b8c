// Cylinders: capped and open, in any direction, sheared by an uneven scale.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4, -7> right 4/3*x look_at <0, .6, 0> angle 48 }
light_source { <-5, 8, -7>, rgb 1 }
background { rgb <.3, .2, .2> }
cylinder { <-2.6, 0, 0>, <-2.6, 1.8, 0>, .7 pigment { rgb <.9, .7, .3> } }
cylinder { <-1, 0, -.4>, <-.4, 1.6, .3>, .6 open pigment { rgb <.3, .8, .7> } }
cylinder { <.4, .5, -1>, <2, .5, .8>, .45 pigment { rgb <.8, .3, .5> } }
cylinder { 0, 2*y, .5 rotate 35*z scale <1, 1, .4> translate <2.8, 0, .5>
    pigment { rgb <.5, .5, .9> } }
plane { y, -.01 pigment { rgb .6 } }

// no_shadow, no_image, no_reflection: three spheres before a mirror.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.5, -8> right 4/3*x look_at <0, 1, 0> angle 45 }
light_source { <-4, 8, -6>, rgb 1 }
background { rgb <.3, .4, .6> }
sphere { <-2.2, .7, 0>, .7 no_shadow pigment { rgb <.9, .4, .3> } }
sphere { <0, .7, 0>, .7 no_image pigment { rgb <.4, .9, .3> } }
sphere { <2.2, .7, 0>, .7 no_reflection pigment { rgb <.4, .5, .9> } }
box { <-4, .1, 2>, <4, 4, 2.2> pigment { rgb .1 } finish { reflection .8 } }
plane { y, -.02 pigment { rgb .7 } }

// +K sets clock for a single picture.
// compare: exact
// options: +K0.35
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -8> right 4/3*x look_at <0, .8, 0> angle 42 }
light_source { <-5, 9, -6>, rgb 1 }
box { <-1, -.2, -.2>, <1, .2, .2> rotate 360*clock*z translate 1.2*y
    pigment { rgb <.9, .4, .2> } }
sphere { <4*clock - 2, .3, -1.4>, .3 pigment { rgb <.3, .8*clock_on, .9> } }
cylinder { <-2, .1, -2>, <-1 + 4*clock_delta + frame_number, .1, -2>, .1 pigment { rgb .9 } }
plane { y, -.01 pigment { rgb .6 } }

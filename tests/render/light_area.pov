// area_light without jitter: every point asked, adaptive, a single row.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 7, -8> right 4/3*x look_at <0, .2, 0> angle 40 }
light_source { <-4, 5, -2>, rgb <.7, .5, .4> area_light 1.5*x, 1.5*z, 5, 5 }
light_source { <4, 5, -2>, rgb <.4, .5, .7>
    area_light <1, 0, 1>, <0, 1.2, 0>, 9, 9 adaptive 1 }
light_source { <0, 4, 4>, rgb .4 area_light 2*x, 2*z, 6, 1 }
sphere { <-1.4, .8, 0>, .6 pigment { rgb .9 } }
box { <.6, .4, -.5>, <1.5, 1.4, .4> pigment { rgb .9 } }
cylinder { <0, .01, -1.5>, <0, 1.2, -1.5>, .15 pigment { rgb .9 } }
plane { y, 0 pigment { rgb .9 } }

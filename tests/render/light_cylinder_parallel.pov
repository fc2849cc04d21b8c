// cylinder lights with radius, falloff, tightness; a parallel light and a
// parallel spotlight (whose cone is then the whole world).
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 8, -8> right 4/3*x look_at <0, .2, 0> angle 40 }
light_source { <-3, 5, -1>, rgb <1, .6, .5>
    cylinder radius .7 falloff 1.1 tightness 0 point_at <-2, 0, 0> }
light_source { <0, 5, 0>, rgb <.5, 1, .6>
    cylinder radius .3 falloff 1.2 tightness 2 point_at <.2, 0, .3> }
light_source { <6, 7, 3>, rgb <.2, .25, .4> parallel point_at <1, 0, 0> }
light_source { <3, 5, 0>, rgb .15
    spotlight radius 10 falloff 14 parallel point_at <2.3, 0, .3> }
sphere { <-1.9, .5, .1>, .4 pigment { rgb .9 } }
cylinder { <.3, .01, .5>, <.3, 1, .5>, .25 pigment { rgb .9 } }
box { <2.2, .01, -.5>, <2.6, .7, 0> pigment { rgb .9 } }
plane { y, 0 pigment { rgb .9 } }

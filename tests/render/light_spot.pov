// spotlight: radius and falloff, tightness, defaults, point_at.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 8, -8> right 4/3*x look_at <0, .2, 0> angle 40 }
light_source { <-3, 5, 0>, rgb <1, .6, .5>
    spotlight radius 12 falloff 22 point_at <-2, 0, 0> }
light_source { <0, 5, -1>, rgb <.5, 1, .6>
    spotlight radius 8 falloff 25 tightness 30 point_at <.3, 0, .5> }
light_source { <4, 3, -1>, rgb <.5, .7, 1> spotlight point_at <2.3, 0, 0> }
light_source { <0, 4, 4>, rgb .8
    spotlight radius 0 falloff 15 tightness 0 point_at <0, 0, 2.5> }
sphere { <-1.9, .5, .1>, .4 pigment { rgb .9 } }
cylinder { <.3, .01, .5>, <.3, 1, .5>, .25 pigment { rgb .9 } }
box { <2, .01, -.5>, <2.5, .7, 0> pigment { rgb .9 } }
plane { y, 0 pigment { rgb .9 } }

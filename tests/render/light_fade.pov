// fade_distance and fade_power of point, spot and parallel lights.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 8, -8> right 4/3*x look_at <0, .2, 0> angle 40 }
light_source { <-2, 1.5, 0>, rgb <1, .6, .5> fade_distance 1 fade_power 2 }
light_source { <2.2, 3, 0>, rgb <.5, .9, 1.2> fade_distance 2 fade_power 3
    spotlight radius 20 falloff 30 point_at <2, 0, 0> }
light_source { <0, 3, 6>, rgb .4 fade_distance 4 fade_power 1
    parallel point_at <0, 0, 0> }
sphere { <-1, .5, -.6>, .5 pigment { rgb .9 } }
box { <1, .01, -.5>, <1.5, .7, 0> pigment { rgb .9 } }
plane { y, 0 pigment { rgb .9 } }

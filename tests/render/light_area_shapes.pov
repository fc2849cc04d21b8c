// area_light: circular, orient, as a spotlight, with fading.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 7, -8> right 4/3*x look_at <0, .2, 0> angle 40 }
light_source { <-4, 5, -2>, rgb <.8, .6, .5>
    area_light 2*x, 2*z, 7, 7 circular }
light_source { <4, 5, -2>, rgb <.5, .6, .8>
    area_light 1.5*x, 1.5*y, 5, 5 circular orient adaptive 2 }
light_source { <0, 6, 3>, rgb .8 spotlight radius 12 falloff 18
    point_at <0, 0, -.5> area_light x, z, 4, 4
    fade_distance 5 fade_power 2 }
sphere { <-1.4, .8, 0>, .6 pigment { rgb .9 } finish { phong .5 } }
box { <.6, .4, -.5>, <1.5, 1.4, .4> pigment { rgb .9 } }
cylinder { <0, .01, -1.5>, <0, 1.2, -1.5>, .15 pigment { rgb .9 } }
plane { y, 0 pigment { rgb .9 } }

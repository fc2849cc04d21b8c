// Before version 3.7 +UA leaves out sky and background, but in mirrors.
// compare: exact
// options: +UA
#version 3.6;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -8> right 4/3*x look_at <0, .8, 0> angle 42 }
light_source { <-5, 9, -6>, rgb 1 }
background { rgbt <.2, .4, .6, .5> }
sky_sphere { pigment { gradient y color_map { [0 rgbt 1] [1 rgb 1] } } }
sphere { <-1.8, .9, 0>, .9 pigment { rgbt <.9, .4, .2, .6> } }
sphere { <1.9, .9, 0>, .9 pigment { rgb .1 } finish { reflection .8 } }

// area_illumination: shading, highlights and fading from the whole area, one
// light close to the floor.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 6, -8> right 4/3*x look_at <0, .2, 0> angle 40 }
light_source { <-1.5, 1.5, 0>, rgb <.8, .6, .4>
    area_light 2*x, 2*z, 6, 6 area_illumination on
    fade_distance 1.5 fade_power 2 }
light_source { <4, 3, -2>, rgb <.3, .4, .6>
    area_light 2*z, 2*y, 5, 5 area_illumination }
sphere { <1.2, .6, -.4>, .6 pigment { rgb .9 } finish { phong .7 phong_size 30 } }
box { <-2.6, .01, -1.6>, <-2.1, .8, -1.1> pigment { rgb .9 } }
plane { y, 0 pigment { rgb .9 } }

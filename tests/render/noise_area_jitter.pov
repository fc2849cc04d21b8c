// area_light with jitter: wide soft shadows; every point draws its own.
// compare: noise
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 7, -4> right 4/3*x look_at <0, 0, -.3> angle 42 }
light_source { <-1, 5, 1>, rgb 1.2
    area_light 4*x, 4*z, 9, 9 jitter adaptive 2 }
#declare I = 0;
#while (I < 5)
    box { <I - 2.2, 1.4, -2>, <I - 1.7, 1.5, 2> pigment { rgb <.9, .4, .3> } }
    #declare I = I + 1;
#end
sphere { <0, .7, -1>, .5 pigment { rgb <.3, .6, .9> } }
plane { y, 0 pigment { rgb .9 } }

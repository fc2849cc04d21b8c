// fog_type 2: a ground fog and a tilted one, seen up, down and along, in a
// mirror, over the horizon, and weakening a lamp; its type is any number.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -9> right 4/3*x look_at <0, 1.8, 0> angle 55 }
light_source { <-4, 9, -6>, rgb 1.1 media_attenuation on }
background { rgb <.2, .3, .6> }
#declare Kinds = array[2] { 1, 2 };
fog { fog_type int(2.5) distance 6 rgb <.8, .8, .7> fog_offset .3 fog_alt .7 }
fog { fog_alt 1.5 fog_offset -1 distance 14 rgbt <.9, .4, .3, .2> fog_type Kinds[1]
    up 2*y rotate -25*z translate 5*y scale 3 }
#declare I = 0;
#while (I < 5)
    cylinder { <1.7*I - 4, 0, 3*I - 3>, <1.7*I - 4, 4, 3*I - 3>, .3
        pigment { rgb <.2, .5, .9> } }
    #declare I = I + 1;
#end
box { <-6, 0, 6>, <-2, 3.5, 6.2> pigment { rgb .1 } finish { reflection .8 } }
plane { y, 0 pigment { checker rgb .8, rgb .4 } }

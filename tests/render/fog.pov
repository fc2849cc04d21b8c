// fog of type 1, over a background, objects and a mirror; hollow or not
// decides whether there is fog inside a glass ball.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <0, 2, -7> right 4/3*x look_at <0, 1, 0> angle 50 }
light_source { <-4, 8, -6>, rgb 1.2 }
background { rgb <.2, .3, .5> }
fog { distance 12 color rgb <.7, .75, .8> }
#declare I = 0;
#while (I < 6)
    cylinder { <1.4*I - 3, 0, 3*I - 2>, <1.4*I - 3, 3, 3*I - 2>, .4
        pigment { rgb <.9, .4, .2> } }
    #declare I = I + 1;
#end
sphere { <-.9, .9, -2>, .7 hollow pigment { rgbt <.8, 1, .8, .9> } }
sphere { <1, .9, -2>, .7 pigment { rgbt <.8, .8, 1, .9> } }
box { <-4, .1, 6>, <-1, 4, 6.2> pigment { rgb .1 } finish { reflection .8 } }
plane { y, 0 pigment { checker rgb .8, rgb .5 scale 2 translate .3 } }

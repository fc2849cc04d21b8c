// An omnimax camera, aimed: the lower part of its disc is cut off.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { omnimax location <.3, 1.5, -1> right 1.2*x up 1.1*y
    look_at <.2, 1.4, 1> sky <.2, 1, 0> }
light_source { <-4, 7, -8>, rgb 1 }
background { rgb <.4, .25, .2> }
#declare I = 0;
#while (I < 12)
    sphere { <3, .8, 0>, .7 rotate 30*I*y
        pigment { checker rgb <.9, .3, .1>, rgb <I/12, .5, 1 - I/12> scale .3 } }
    #declare I = I + 1;
#end
box { <-.2, .5, -.2>, <.2, 1.2, .2> pigment { rgb <.9, .8, .3> } }
plane { y, 0 pigment { checker rgb .8, rgb .4 } }

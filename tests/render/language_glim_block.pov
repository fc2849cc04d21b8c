// What stands in #ifdef (Glim) is for glim alone: settings of ours, which
// leave the conventional picture as it is, in several blocks.
// compare: exact
#version 3.7;
#ifdef (Glim)
    #declare Marker = (Glim > 0);
#else
    #declare Marker = yes;
#end
global_settings { assumed_gamma 1 }
camera { location <0, 3, -7> right 4/3*x look_at <0, .5, 0> angle 42 }
light_source { <-5, 9, -6>, rgb 1 #ifdef (Glim) #end }
sphere { <-1, .7, 0>, .7 pigment { rgb <.9, .4, .2> }
    finish { diffuse .7 #ifndef (Glim) ambient .2 #else ambient .2 #end } }
#if (Marker) box { <.4, 0, -.5>, <1.4, 1, .5> pigment { rgb <.3, .6, .9> } } #end
plane { y, -.01 pigment { rgb .6 } }

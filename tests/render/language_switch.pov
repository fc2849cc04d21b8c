// #switch with #case, #range, #else and falling through; #ifdef, #ifndef,
// #undef; a block only Glim reads is skipped.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1
    #ifdef (Glim_Is_Never_This) light_mesh { spacing 1 } #end
}
camera { location <0, 5, -8> right 4/3*x look_at <0, .4, 0> angle 42 }
light_source { <-5, 9, -6>, rgb 1 }
#declare I = 0;
#while (I < 8)
    #switch (I)
    #case (0)
        #declare Tint = rgb <.9, .3, .2>;
    #break
    #case (1)
    #case (2)
        #declare Tint = rgb <.9, .8, .2>;
    #range (2, 3)
        sphere { <I - 3.5, 1.2, 0>, .2 pigment { rgb .9 } }
    #break
    #range (4.5, 6)
        #declare Tint = rgb <.3, .8, .4>;
    #break
    #else
        #declare Tint = rgb <.3, .4, .9>;
    #end
    box { <I - 3.8, 0, -.3>, <I - 3.2, .9, .3> pigment { Tint } }
    #declare I = I + 1;
#end
#declare Known = 1;
#undef Known
#ifdef (Known) sphere { <-2, .4, -2>, .4 pigment { rgb <1, 0, 0> } } #end
#ifndef (Known) sphere { <0, .4, -2>, .4 pigment { rgb <.8, .5, .9> } } #end
#ifdef (I) cone { <2, 0, -2>, .4, <2, .9, -2>, 0 pigment { rgb <.4, .9, .9> } } #end
plane { y, -.01 pigment { rgb .6 } }

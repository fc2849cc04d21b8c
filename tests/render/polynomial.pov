// cubic, quartic and poly: surfaces of degree 3, 4 and 6, kept in bounds by
// clipped_by, with and without sturm.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -9> right 4/3*x look_at <0, .9, 0> angle 42 }
light_source { <-5, 8, -7>, rgb 1 }
background { rgb <.2, .2, .3> }
// y^3 - y + x^2 + z^2 - .3
cubic { <0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 1, 0, -.3>
    clipped_by { sphere { 0, 1.2 } } sturm rotate 20*z translate <-2.6, 1.1, 0>
    pigment { rgb <.9, .5, .2> } }
// x^4 + y^4 + z^4 - 1
quartic {
    <1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0,
     0, 0, 0, 0, 0, 1, 0, 0, 0, -1>
    sturm rotate <20, 30, 0> scale .9 translate <0, 1.1, 0>
    pigment { rgb <.3, .8, .6> } }
// (x^2 + y^2 + z^2 - 1) spelled in degree 2, with the cross terms
poly { 2, <1, .5, .3, 0, 2, .4, 0, 1, 0, -.8> rotate 30*y
    translate <2.6, 1, 0> pigment { rgb <.5, .5, .95> } }
// x^6 + y^6 + z^6 - .1, of which only 4 of 84 terms are not 0
poly { 6,
    <1,
    #declare I = 2;
    #while (I < 84)
        #if ((I = 57) | (I = 78)) 1, #else 0, #end
        #declare I = I + 1;
    #end
    -.1>
    rotate 20*y translate <1.3, .75, -1.6> scale .9
    clipped_by { sphere { <1.2, .7, -1.4>, 1.2 } }
    pigment { rgb <.9, .8, .3> } }
plane { y, -.05 pigment { rgb .6 } }

// Fog weakens lights that ask for it by media_attenuation, and no others.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4, -8> right 4/3*x look_at <0, .4, 0> angle 42 }
fog { distance 9 rgb <.2, .25, .3> }
light_source { <-5, 7, -3>, rgb <1.2, .3, .2> media_attenuation on }
light_source { <5, 7, -3>, rgb <.2, .3, 1.2> }
sphere { <-1, .7, 0>, .7 pigment { rgb .9 } }
box { <.4, 0, -.4>, <1.4, 1.2, .6> pigment { rgb .9 } }
plane { y, -.01 pigment { rgb .8 } }

// turbulence in fog: noise at the middle of the way takes some of it; between
// two layers, over a plane, with each of its numbers.
// compare: exact
// options: +W320 +H240
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -7> right 4/3*x look_at <0, 1, 0> angle 50 }
light_source { <-4, 8, -6>, rgb 1.2 }
background { rgb <.2, .3, .5> }
fog { distance 12 color rgb <.7, .75, .8> turbulence 9 turb_depth .9 }
fog { fog_type 2 distance 9 fog_alt .5 fog_offset .5 color rgb <.9, .7, .5>
    turbulence <7, 9, 8> octaves 3 omega .7 lambda 3 }
box { <-9, 3, 14>, <9, 9, 15> pigment { rgb .05 } }
box { <-9, 0, 4>, <9, 3, 5> pigment { rgb .05 } }
plane { y, 0 pigment { rgb .05 } }

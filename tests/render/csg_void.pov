// Unions and texts of nothing as parts: nothing is left of an intersection with
// them, and they take nothing away. A light in a part that is left out shines.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.5, -6> look_at <0, .5, 0> angle 45 }
plane { y, 0 pigment { rgb .7 } }
#declare Nothing = union { #for (I, 1, 0) sphere { I, 1 } #end };
difference { box { -1, 1 translate -1.5*x }
    intersection { object { Nothing } sphere { <-1.5, 1, -1>, .5 } }
    pigment { rgb z } }
difference { object { Nothing } sphere { 0, 1 } pigment { rgb x } }
intersection { union { light_source { <-4, 6, -5>, 1 } } sphere { 0, 1 }
    pigment { rgb y } }
difference { box { 0, 1 translate x } text { ttf "timrom.ttf" " " 1, 0 }
    pigment { rgb <1, 1, 0> } }
intersection { box { 0, 1 translate <2, 0, 2> } text { ttf "timrom.ttf" "" 1, 0 }
    pigment { rgb <1, 1, 0> } }
merge { object { Nothing } sphere { <2.1, .5, -1>, .5 } pigment { rgb <1, 0, 1> } }

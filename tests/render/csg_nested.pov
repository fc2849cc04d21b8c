// Declared objects used again inside CSG, inverse solids, differences of
// unions, an intersection with a difference, transformed at every level.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2, 4, -8> right 4/3*x look_at <0, .8, 0> angle 42 }
light_source { <-6, 9, -6>, rgb 1 }
background { rgb <.2, .3, .3> }
#declare Rounded = intersection {
    box { -1, 1 } sphere { 0, 1.35 pigment { rgb <.9, .8, .4> } }
    pigment { rgb <.8, .4, .3> } };
#declare Bore = union {
    cylinder { -2*x, 2*x, .35 } cylinder { -2*z, 2*z, .35 }
    object { cylinder { -2*y, 2*y, .35 } scale <1.5, 1, 1> }
    pigment { rgb <.3, .5, .9> } };
difference {
    object { Rounded }
    object { Bore rotate 10*y }
    rotate <0, 25, 0> translate <-1.7, 1.1, 0>
}
intersection {
    object { Rounded scale <1, .8, 1> }
    object { Bore inverse }
    object { sphere { <.9, .9, -.9>, .9 } inverse pigment { rgb <.4, .9, .5> } }
    rotate -20*y translate <1.4, .9, .2>
}
union {
    difference { object { Bore scale .5 } box { <-2, 0, -2>, <2, 2, 2> pigment { rgb .8 } } }
    sphere { .3*y, .2 pigment { rgb <.9, .3, .8> } }
    translate <-.2, .2, -2.2>
}
plane { y, -.9 pigment { rgb .6 } }

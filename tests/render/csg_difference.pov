// difference: several holes, a hole's own pigment, cut_away textures of the
// first object, a shell, and a difference from a difference.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1, 4, -8> right 4/3*x look_at <0, .7, 0> angle 42 }
light_source { <-6, 9, -6>, rgb 1 }
background { rgb <.3, .2, .2> }
difference {
    box { -1, 1 pigment { rgb <.9, .7, .3> } }
    cylinder { -2*z, 2*z, .6 pigment { rgb <.8, .2, .2> } }
    cylinder { -2*y, 2*y, .6 pigment { rgb <.2, .7, .3> } }
    cylinder { -2*x, 2*x, .6 }
    pigment { rgb .9 }
    rotate 30*y translate <-2.1, 1.01, 0>
}
difference {
    sphere { 0, 1 }
    sphere { 0, .85 }
    box { <-2, .2, -2>, <2, 2, 2> }
    pigment { rgb <.3, .6, .9> } rotate -25*x translate <.5, 1.01, .6>
}
difference {
    cylinder { 0, 1.2*y, 1 }
    difference { sphere { 1.2*y, .9 } cylinder { -1*y, 3*y, .3 } }
    pigment { rgb <.6, .9, .5> } translate <2.4, .01, -.6>
}
plane { y, -.02 pigment { rgb .6 } }

// intersection: a lens, a corner of three planes, a half torus; each part
// brings its own pigment, the parts without take the whole's.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -8> right 4/3*x look_at <0, .8, 0> angle 42 }
light_source { <-5, 8, -7>, rgb 1 }
background { rgb <.2, .2, .3> }
intersection {
    sphere { <-.6, 0, 0>, 1.2 pigment { rgb <.9, .4, .3> } }
    sphere { <.6, 0, 0>, 1.2 pigment { rgb <.3, .5, .9> } }
    rotate 40*y translate <-2.3, 1.2, 0>
}
intersection {
    plane { <-1, 0, -1>, .3 }
    plane { <1, 0, -1>, .3 pigment { rgb <.9, .8, .3> } }
    plane { y, .8 }
    sphere { 0, 1.4 pigment { rgb <.5, .9, .4> } }
    pigment { rgb <.7, .7, .7> } rotate 15*y translate <0, 1, .4>
}
intersection {
    torus { .9, .35 rotate 90*x pigment { rgb <.4, .8, .8> } }
    plane { <-1, -.4, 0>, 0 pigment { rgb <.9, .4, .7> } }
    translate <2, 1.1, 0>
}
plane { y, -.02 pigment { rgb .6 } }

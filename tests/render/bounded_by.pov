// bounded_by smaller than what it bounds: rays that miss the box, or any bound
// of a union, miss the object; others meet all of it, outside of the box too.
// A box larger than the shape's own, and bounds of what is flat, change nothing.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -12> right 4/3*x look_at 0 angle 40 }
light_source { <-5, 8, -7>, rgb 1 shadowless }
background { rgb <.2, .2, .25> }
#default { pigment { rgb <.9, .6, .3> } }
#declare Small = box { <-1, -.6, -1>, <1, .6, 1> }
cylinder { -1.4*y, 1.4*y, .3 bounded_by { Small } translate <-4, 1.5, 0> }
cylinder { -1.4*y, 1.4*y, .3
    bounded_by { box { <-9, -.6, -9>, <9, .6, 9> } } translate <-3, 1.5, 0> }
torus { 1, .3 rotate -60*x bounded_by { sphere { 0, .6 } }
    translate <-1.3, 1.5, 0> }
quadric { <1, 0, 1>, 0, 0, -.1
    clipped_by { box { <-1, 0, -1>, <1, 1.2, 1> } } bounded_by { Small }
    translate <.6, 1, 0> }
superellipsoid { <.3, .3> bounded_by { box { -.4, .4 } }
    translate <2, 1.5, 0> }
sphere { 0, .9 bounded_by { box { -.5, .5 rotate 45*z } } translate <4, 1.5, 0> }
union {
    quadric { <1, 0, 1>, 0, 0, -.1 rotate 60*z }
    sphere { <.7, .3, -.3>, .4 pigment { rgb y } }
    bounded_by { box { -1, 1 } sphere { .3*x, .9 } }
    rotate 20*y translate <-3.5, -1.5, 0>
}
union {
    union { cylinder { -3*x, 3*x, .2 } bounded_by { box { -.9, .9 } } }
    union { torus { .8, .2 }
        bounded_by { box { <0, -1, -2>, <2, 1, 2> } } }
    bounded_by { sphere { 0, 1.1 } } translate <-1, -1.5, 0>
}
difference {
    cylinder { -9*x, 9*x, .5 } cylinder { -9*x, 9*x, .4 }
    plane { z, 0 rotate 20*x } bounded_by { box { -.8, .8 } }
    translate <1.5, -1.5, 0>
}
mesh { triangle { <-1, -1, 0>, <1, -1, 0>, <0, 1, 0> } bounded_by { box { -.3, .3 } }
    translate <4, -1.5, 0> }

// clipped_by cuts without closing, bounded_by changes nothing, and each may
// take its object from the other; several clipping objects; open shapes.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -8> right 4/3*x look_at <0, .9, 0> angle 42 }
light_source { <-5, 8, -7>, rgb 1 }
background { rgb <.2, .2, .25> }
sphere { 0, 1 clipped_by { plane { <.3, 1, -.5>, .3 } }
    pigment { rgb <.9, .5, .3> } translate <-2.7, 1.05, 0> }
box { -1, 1 clipped_by { sphere { <-.9, .9, -.9>, 1.3 inverse } }
    bounded_by { clipped_by }
    pigment { rgb <.3, .8, .6> } rotate 30*y scale .9 translate <-.5, .95, .6> }
cylinder { 0, 2*y, .7 open
    bounded_by { box { <-.8, -.1, -.8>, <.8, 2.1, .8> } }
    clipped_by { plane { <1, .6, -.5>, .9 } plane { <-1, .2, 0>, .5 } }
    pigment { rgb <.6, .5, .9> } translate <1.4, .05, .2> }
union {
    sphere { 0, .6 } torus { .8, .15 }
    clipped_by { box { -2, <.5, 2, .1> } } bounded_by { sphere { 0, 1.2 } }
    pigment { rgb <.9, .8, .3> } rotate -30*y translate <2.8, .8, -.4>
}
plane { y, -.02 pigment { rgb .6 } }

// lathe: every curve, closed and open, seen from the side and from above, cut:
// what is open has a hole down its axis, that of Bezier curves as wide as their
// control points say.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -8> right 4/3*x look_at <0, .6, 0> angle 45 }
light_source { <-4, 7, -8>, rgb 1 }
background { rgb <.2, .25, .2> }
lathe { 6, <0, 0>, <1, .1>, <.6, .6>, <.9, 1.2>, <.4, 1.4>, <0, 1.1>
    pigment { rgb <.9, .5, .2> } translate <-2.4, 0, 1.2> }
lathe { quadratic_spline 6,
    <.2, -.5>, <0, 0>, <.9, .4>, <.4, 1>, <.6, 1.4>, <.3, 1.7>
    pigment { rgb <.3, .8, .7> } translate <0, 0, 1.4> }
lathe { cubic_spline 9, <.3, 1>, <.3, 0>, <1, .1>, <1.1, .6>, <.6, .8>, <.7, 1.2>,
    <.3, 1>, <.3, 0>, <1, .1>
    pigment { rgb <.6, .5, .95> } translate <2.3, 0, 1> }
lathe { bezier_spline 8, <.2, 0>, <1.2, 0>, <1, 1>, <.5, 1>,
    <.5, 1>, <.1, 1>, <.4, .4>, <.2, 0>
    pigment { gradient y color_map { [.5 rgb .8] [.5 rgb <.5, .2, .1>] } scale .3 }
    rotate 70*x translate <-2.2, .8, -1.4> }
difference {
    lathe { linear_spline 5, <.2, 0>, <1, 0>, <1, .8>, <.2, .8>, <.2, 0> sturm }
    box { <0, .2, -2>, <2, 1, 0> pigment { rgb <.3, .5, .9> } }
    pigment { rgb <.9, .8, .3> } rotate 20*y translate <.2, .1, -1.4> }
lathe { cubic_spline 6, <0, -1>, <.2, 0>, <.7, .3>, <.3, .7>, <.6, 1.1>, <1, 1>
    clipped_by { plane { x, .1 } }
    pigment { rgb <.9, .3, .4> } translate <2.2, 0, -1.4> }
plane { y, -.05 pigment { checker rgb .8, rgb .5 } }
difference {
    lathe { linear_spline 4, <.4, 0>, <.2, .3>, <.4, .6>, <.25, .9> }
    box { <-1, -1, -1>, <1, 1, 0> pigment { rgb <.2, .3, .9> } }
    pigment { rgb <.9, .2, .2> } translate <-.6, .2, -2.2> }
difference {
    lathe { bezier_spline 4, <.4, 0>, <.1, .3>, <.05, .7>, <.4, .9> }
    box { <-1, -1, -1>, <1, 1, 0> pigment { rgb <.2, .3, .9> } }
    pigment { rgb <.4, .9, .2> } translate <1.2, .2, -2.4> }

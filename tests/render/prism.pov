// prism: every curve, with holes, conic and open, turned, in CSG; the last of
// several words for the sweep counts.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -8> right 4/3*x look_at <0, .3, 0> angle 45 }
light_source { <-4, 7, -8>, rgb 1 }
background { rgb <.2, .25, .2> }
prism { conic_sweep linear_sweep 0, .7, 10, <-1, -1>, <1, -1>, <.8, 1>, <0, .3>, <-1, -1>,
    <-.4, -.7>, <.3, -.8>, <.4, -.2>, <-.1, 0>, <-.4, -.7>
    pigment { rgb <.9, .5, .2> } translate <-2.4, 0, 1.2> }
prism { quadratic_spline 0, .6, 7,
    <0, -1>, <-1, 0>, <0, 1>, <1, .4>, <.6, -.7>, <-.2, -1>, <-1, 0>
    pigment { rgb <.3, .8, .7> } translate <0, 0, 1.4> }
prism { cubic_spline linear_sweep 0, .5, 15,
    <-.2, -1>, <-1, 0>, <0, 1>, <1, .4>, <.6, -.7>, <-.2, -1>, <-1, 0>, <0, 1>,
    <0, -.5>, <-.4, 0>, <0, .5>, <.3, .3>, <.3, -.4>, <-.4, 0>, <0, .5>
    pigment { rgb <.6, .5, .95> } translate <2.3, 0, 1> }
prism { conic_sweep bezier_spline .2, 1, 8,
    <-1, 0>, <-1, 1.2>, <1, 1.2>, <1, 0>, <1, 0>, <.5, -1.5>, <-.3, 0>, <-1, 0>
    pigment { rgb .8 } rotate 180*x translate <-2.2, 1, -1.4> }
prism { linear_spline conic_sweep -.6, .8, 5,
    <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1> open
    pigment { rgb <.9, .3, .4> } translate <0, .6, -1.4> }
difference {
    sphere { 0, 1 }
    prism { cubic_spline -1, 1.1, 6, <.5, 0>, <0, -.5>, <-.5, 0>, <.3, .5>,
        <0, -.5>, <-.5, 0> pigment { rgb <.3, .5, .9> } }
    pigment { rgb <.9, .8, .3> } rotate -20*x translate <2.2, .7, -1.4> }
plane { y, -.05 pigment { checker rgb .8, rgb .5 } }

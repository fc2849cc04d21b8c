// blob: balls and cylinders, of negative strength, moved parts, old components;
// in CSG and seen through.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <0, 3, -8> right 4/3*x look_at <0, .8, 0> angle 45 }
light_source { <-4, 7, -8>, rgb 1 }
background { rgb <.2, .25, .2> }
blob { threshold .6 component 1, 1, <-2.3, .9, 1> component 1, 1, <-1.5, .8, 1>
    component 1, 1, <-2, 1.5, 1> pigment { rgb <.9, .5, .2> } }
blob { threshold .5 cylinder { <-.9, .5, 1>, <.9, 1.2, 1>, .6, 1 }
    cylinder { <0, 0, 1>, <0, 2, 1.5>, .5, strength .9 }
    sphere { <.5, 1.1, .6>, .6, -1.5 } pigment { rgb <.3, .8, .7> } sturm }
blob { sphere { 0, 1, 2 scale <1.2, .5, 1> rotate 40*z translate y }
    sphere { <.7, .6, 0>, .8, 2 } cylinder { 0, x, .5, 3 rotate 90*y }
    hierarchy off pigment { rgb <.6, .5, .95> } translate <2.2, .4, 1> }
difference { blob { threshold .4 sphere { 0, 1.2, 1 } sphere { x, 1, .8 } }
    plane { z, 0 pigment { rgb <.9, .2, .2> } }
    pigment { rgb .8 } rotate 30*y scale .9 translate <-2, .7, -1.4> }
blob { threshold .3 sphere { 0, 1, 1 } sphere { x, 1, 1 } inverse
    pigment { rgbf <.7, .9, .7, .8> } interior { ior 1.2 }
    translate <0, .8, -1.4> }
blob { threshold .5 cylinder { -x, x, .7, 1 } clipped_by { plane { x, .3 } }
    pigment { checker rgb <.9, .3, .4>, rgb .9 scale .3 } translate <2.4, .6, -1> }
plane { y, -.05 pigment { checker rgb .8, rgb .5 } }

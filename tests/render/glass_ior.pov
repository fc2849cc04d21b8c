// Refraction: a solid ball, a shell, a slab and a cone of glass, of several
// ior; total reflection inside.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 15 }
camera { location <0, 2.5, -8> right 4/3*x look_at <0, .5, 0> angle 40 }
light_source { <-4, 8, -6>, rgb 1 }
background { rgb <.5, .7, .9> }
#default { finish { ambient .1 diffuse .3 phong .4 } }
plane { y, -.42 pigment { checker rgb <.9, .5, .3>, rgb .95 translate .27 }
    finish { diffuse .8 phong 0 } }
sphere { <-2.3, .5, 0>, .9 pigment { rgbf <.95, .95, .95, .9> } interior { ior 1.5 } }
difference { sphere { 0, .8 } sphere { 0, .65 }
    pigment { rgbf <.9, 1, .9, .9> } interior { ior 1.3 } translate <-.3, .4, -.4> }
box { <-.6, -.4, -.2>, <.6, 1.4, .2> rotate 35*y translate <1.3, 0, .8>
    pigment { rgbt <.8, .9, 1, .85> } interior { ior 1.8 } }
cone { <2.5, -.4, -.5>, .7, <2.5, 1.2, -.5>, .1
    pigment { rgbf <1, .9, .8, .85> } interior { ior .8 } }

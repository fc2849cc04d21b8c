// caustics: brighter in the middle of a glass's shadow, by each surface; coloured,
// of an edge, weak and strong.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <0, 4, -7> right 4/3*x look_at <0, .3, 0> angle 45 }
light_source { <-4, 9, -8>, rgb .8 }
#default { finish { ambient .05 diffuse .1 } }
sphere { <-2, .9, .5>, .8 pigment { rgbt .95 } interior { caustics .3 ior 1.3 } }
sphere { <0, .9, .5>, .8 pigment { rgbf <.9, .6, .5, .9> }
    interior { caustics 1 } }
box { -.6, .6 rotate <20, 30, 0> translate <2, 1, .5> pigment { rgbt .9 }
    interior { caustics .1 } }
cylinder { -.5*x, .5*x, .5 translate <.5, .7, -1.3> pigment { rgbf .9 }
    interior { caustics 3 } }
disc { <1.6, 1.2, -2>, y, .7 pigment { rgbt .95 }
    normal { leopard .7 scale .04 } interior { caustics .5 } }
plane { y, 0 pigment { rgb <.7, .8, .6> } finish { diffuse .7 } }

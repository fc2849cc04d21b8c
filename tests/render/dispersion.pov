// dispersion: a prism, a ball and a wedge divide light into colours, in a
// different number of them, before stripes; one is inside of another.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <0, 1.5, -6> right 4/3*x look_at <0, .8, 0> angle 45 }
light_source { <-4, 6, -5>, rgb 1 }
plane { y, 0 pigment { checker rgb .9, rgb .2 scale .7 } }
plane { -z, -4 pigment { gradient x color_map { [.5 rgb 1] [.5 rgb .1] } scale .8 } }
#default { finish { ambient 0 diffuse .05 reflection .05 } }
sphere { <-1.5, 1, 0>, .9 pigment { rgbf <1, .95, .9, .9> }
    interior { ior 1.5 dispersion 1.15 dispersion_samples 5 } }
prism { -1, 1, 4, <-.7, 0>, <.7, 0>, <0, 1.2>, <-.7, 0> rotate -20*y translate <.8, 1.03, -.5>
    pigment { rgbf 1 } interior { ior 1.4 dispersion 1.1 } }
box { <1.7, .1, -1>, <2.5, 1.6, 0> rotate 8*z pigment { rgbt .9 }
    interior { ior 1.3 dispersion 1.2 dispersion_samples 2 } }
sphere { <2, .8, -.6>, .3 pigment { rgbt .9 } interior { ior 1.7 dispersion .9 } }

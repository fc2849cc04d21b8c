// reflection with fresnel by the interior's ior, and conserve_energy on a
// coloured glass; both from outside and from inside.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <0, 1.6, -8> right 4/3*x look_at <0, .1, 0> angle 36 }
light_source { <-4, 7, -8>, rgb 1 }
plane { y, -1 pigment { checker rgb <.9, .8, .6>, rgb <.3, .4, .6> translate .3 } }
sky_sphere { pigment { gradient y color_map {
    [0 rgb <.9, .7, .5>] [1 rgb <.2, .4, .9>] } } }
sphere { <-2.1, 0, 0>, .9 pigment { rgb <.5, .1, .1> }
    finish { diffuse .5 reflection { 0, 1 fresnel } }
    interior { ior 1.5 } }
sphere { <0, 0, 0>, .9 pigment { rgbf <.9, 1, .9, .9> }
    finish { diffuse .1 reflection { 0, 1 fresnel on } conserve_energy }
    interior { ior 1.4 } }
sphere { <2.1, 0, 0>, .9 pigment { rgbt <.6, .8, 1, .8> }
    finish { diffuse .2 reflection { .1, .8 fresnel off } conserve_energy } }

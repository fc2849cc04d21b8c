// sky_sphere: two layered pigments, transformed, seen directly, in a mirror
// and through glass; background shows where the sky is transparent.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <0, 1, -6> right 4/3*x look_at <0, 1, 0> angle 60 }
light_source { <-4, 8, -6>, rgb 1 }
background { rgb <.9, .3, .6> }
sky_sphere {
    pigment { gradient y color_map {
        [0 rgb <.9, .8, .6>] [.4 rgb <.3, .5, .9>] [.41 rgbt <.2, .3, .7, .6>]
        [1 rgbt 1] } }
    pigment { radial frequency 6 color_map {
        [0 rgbt <1, 1, 1, .5>] [.5 rgbt <1, 1, 1, 1>] [1 rgbt <1, 1, 1, 1>] } }
    rotate 20*z
}
sphere { <-1.4, .9, 0>, .9 pigment { rgb .1 } finish { reflection .8 } }
sphere { <1.4, .9, 0>, .9 pigment { rgbf 1 } finish { diffuse 0 ambient 0 }
    interior { ior 1.3 } }
plane { y, -.02 pigment { rgb <.5, .6, .4> } }

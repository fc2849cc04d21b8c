// Reflection at a steeply bent normal: a ray that would go into the surface is
// turned out again; the interpolated normal of a triangle does not do so.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.5, -7> right 4/3*x look_at <0, .4, 0> angle 42 }
light_source { <-5, 9, -6>, rgb 1 }
sky_sphere { pigment { gradient y color_map {
    [0 rgb <.9, .5, .2>] [.5 rgb <.9, .9, .6>] [1 rgb <.2, .4, .9>] }
    scale 2 translate -1 } }
#default { pigment { rgb .15 } finish { reflection .7 } }
sphere { <-1.6, .9, 0>, .9 normal { onion 4 sine_wave scale .3 } }
box { <-.5, 0, -.4>, <.7, 1.4, .6> normal { gradient <1, 1, 1> 3 sine_wave scale .23 }
    rotate 20*y }
smooth_triangle { <1.2, 0, 0>, <-1, .1, -.4>, <2.8, 0, 0>, <1, .1, -.3>,
    <2, 1.8, .2>, <.1, 1, -.2> }
plane { y, -.01 pigment { checker rgb .8, rgb .3 translate .3 }
    finish { reflection 0 } }

// projected_through: a lamp through a union that is moved with it, an area light
// through a clipped ball; what stands before the window casts no shadow, what
// stands behind it does; a lamp in a union.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 6, -7> right 4/3*x look_at <0, 0, 0> angle 50 }
plane { y, 0 pigment { checker rgb .9, rgb .6 } finish { ambient .05 } }
light_source { <0, 5, 0>, rgb .6
    projected_through { union {
        box { <-.6, 3, -.1>, <.6, 3.1, .1> } cylinder { <0, 3, .3>, <0, 3.1, .3>, .3 } } }
    rotate 20*y translate <-2, 0, 0> }
light_source { <2, 6, 1>, rgb <.9, .5, .2> area_light .5*x, .5*z, 3, 3
    projected_through { sphere { <2, 3, 1>, .8 clipped_by { plane { x, 2 } } } } }
union {
    light_source { <0, 4, 0>, rgb <.2, .4, .9>
        projected_through { torus { .6, .15 translate 2*y } } }
    sphere { <0, .3, 0>, .3 pigment { rgb .8 } }
    translate <.3, 0, -2>
}
box { <-2.2, 3.6, -.2>, <-1.8, 4, .2> pigment { rgb <1, 0, 0> } }
box { <-2.2, 1, -.2>, <-1.8, 1.4, .2> pigment { rgb <0, 1, 0> } }
sphere { <2, .5, 1>, .5 pigment { rgb .8 } finish { specular .6 } }

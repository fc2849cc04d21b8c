// CSG of one part each, turned: what is left of a loop or of an #if.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> look_at 0 angle 40 }
light_source { <-5, 8, -6>, 1 }
#default { pigment { rgb <.9, .6, .3> } finish { ambient .1 } }
merge { torus { .5, .2 } rotate <50, 0, 20> translate <-1, .8, 0> }
intersection { lathe { linear_spline 4, <0, 0>, <.5, 0>, <.3, 1>, <0, 1> }
    rotate <-30, 0, 40> translate <1.2, .5, 0> }
difference { blob { threshold .5 sphere { -.3*x, .8, 1 } sphere { .4*x, .7, 1 } }
    rotate z*50 translate <-1, -.9, 0> }
merge { intersection { merge { prism { 0, .6, 4, <-.5, -.5>, <.6, -.4>, <0, .6>, <-.5, -.5> } } }
    rotate <40, 30, 0> translate <1, -1, 0> }

// union keeps the surfaces inside, merge removes them: seen through glass.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 12 }
camera { location <0, 2.5, -8> right 4/3*x look_at <0, .9, 0> angle 40 }
light_source { <-5, 8, -7>, rgb 1 }
background { rgb <.5, .6, .8> }
#declare Clear = pigment { rgbt <.9, .7, .4, .6> }
union {
    sphere { <-.6, 0, 0>, .8 }
    sphere { <.5, 0, 0>, .7 }
    cylinder { -1*y, 1*y, .3 }
    pigment { Clear } translate <-1.6, 1.05, 0>
}
merge {
    sphere { <-.6, 0, 0>, .8 }
    sphere { <.5, 0, 0>, .7 }
    cylinder { -1*y, 1*y, .3 }
    pigment { Clear } translate <1.7, 1.05, 0>
}
plane { y, -.02 pigment { checker rgb .8, rgb .4 translate .3 } }

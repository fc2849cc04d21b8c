// bounded_by smaller than a mesh or a patch: rays that miss the box around the
// bounds miss it, others meet all of it. One larger than the mesh, and bounds of
// flat ones, change nothing.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -10> right 4/3*x look_at 0 angle 50 }
light_source { <-4, 8, -6>, rgb 1 shadowless }
plane { y, -2 pigment { checker rgb .9 rgb .6 } }
#default { pigment { rgb <.9, .6, .3> } }
#declare Roof = mesh {
    triangle { <-1.5, -.5, 0>, <1.5, -.5, 0>, <0, 2, 1> }
    triangle { <-1.5, .5, 1>, <1.5, .5, 1>, <0, 2, -1> }
}
#declare Patch = bicubic_patch {
    type 1 flatness 0.01 u_steps 4 v_steps 4
    <-1.5, 0, -1.5>, <-.5, 1.5, -1.5>, <.5, -1, -1.5>, <1.5, 0, -1.5>,
    <-1.5, 1, -.5>, <-.5, 3, -.5>, <.5, 0, -.5>, <1.5, 1, -.5>,
    <-1.5, 0, .5>, <-.5, 0, .5>, <.5, 3, .5>, <1.5, 0, .5>,
    <-1.5, 0, 1.5>, <-.5, 1.5, 1.5>, <.5, 0, 1.5>, <1.5, 0, 1.5>
}
object { Roof bounded_by { box { <-.5, -1, -.5>, <.5, 1.2, .5> } }
    rotate 20*y translate <-3.4, .5, 0> }
object { Roof bounded_by { sphere { 0, .6 } } translate <-1, .5, 0> }
object { Roof bounded_by { sphere { 0, 4 } } translate <3, .5, 2> }
object { Patch bounded_by { box { <-1, -1, -1>, <1, 1, 1> } } scale .8
    translate <1.2, 0, 0> }
object { Patch scale .8 bounded_by { sphere { 0, .7 } } rotate 30*y
    translate <3.3, -.6, -1> }
mesh { triangle { <-1, -1, 0>, <1, -1, 0>, <0, 1, 0> }
    bounded_by { box { -.3, .3 } } translate <-2, -1.4, -2> }

// Julia sets of squares and cubes: quaternions, hypercomplex numbers, a slice
// that is tilted, one cut in CSG.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -9> look_at 0 angle 40 }
light_source { <-5, 8, -6>, 1 }
#default { pigment { rgb <.9, .6, .3> } finish { ambient .1 phong .4 } }
julia_fractal {
    <-.083, 0, -.83, -.025> quaternion sqr max_iteration 5 precision 400
    slice <.2, 0, .3, 1>, .1 translate <-1.7, 1, 0>
}
julia_fractal {
    <-.083, .05, -.43, -.025> quaternion cube max_iteration 4 precision 400
    translate <1.7, 1, 0>
}
julia_fractal {
    <-.162, .163, .56, -.599> hypercomplex max_iteration 5 precision 400
    translate <-1.7, -1.5, 0>
}
difference {
    julia_fractal { <-.083, 0, -.83, -.025> max_iteration 5 precision 400 }
    box { <-2, -2, -2>, <2, 2, -.2> pigment { rgb x } }
    translate <1.7, -1.5, 0>
}

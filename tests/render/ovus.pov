// Ovus of several shapes, in CSG; polynomial.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -7> look_at <0, .4, 0> angle 45 }
light_source { <-5, 8, -6>, 1 }
#default { pigment { rgb <.9, .6, .3> } finish { ambient .1 phong .4 } }
plane { y, -1 pigment { checker rgb .8 rgb .4 } }
ovus { 1, .5 translate -2*x }
ovus { .6, 1 rotate 30*z }
difference { ovus { .8, .7 } box { <-1, -2, -2>, <.1, 3, 0> } translate 2*x }
ovus { .5, .05 translate <.8, -.5, -2> }
ovus { .3, 1.4 scale .3 translate <-.8, -.7, -2> }
polynomial { 4, xyz(4, 0, 0): 1, xyz(0, 4, 0): 1 xyz(0, 0, 4): 1,
    xyz(2, 2, 0): .5, xyz(0, 1, 1): .3, xyz(0, 0, 0): -9, xyz(0, 0, 0): -.1
    sturm translate <0, 1.8, 1> }

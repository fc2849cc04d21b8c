// Ovus with coordinates of its own.
// compare: exact
#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0, 2, -7> look_at <0, .4, 0> angle 45 }
light_source { <-5, 8, -6>, 1 }
#default { pigment { uv_mapping checker rgb x rgb <1, 1, .5> scale .07 } }
ovus { .8, .4 translate -2*x }
ovus { .6, 1 rotate 30*z scale .7 }
ovus { .4, 1 translate 1.8*x scale .8 }
ovus { .5, .05 rotate 60*x translate <.4, -.5, -2> }
difference { ovus { .8, .7 } box { <-1, -2, -2>, <.1, 3, 0> } scale .6 translate <-1.2, -.6, -1> }

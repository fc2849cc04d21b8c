// orthographic with angle 0: the size of a perspective picture at look_at.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera {
  orthographic direction 2*z location <0, 2, -5> angle 0 right 4/3*x look_at 0
}
light_source { <-5, 8, -6> rgb 1 }
sphere { 0, .8 pigment { rgb <.9, .3, .1> } }
plane { y, -1 pigment { checker rgb .8 rgb .4 } }

// A prism with a Bezier outline that is not closed is left out.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -7> look_at <0, 0.5, 0> angle 45 }
light_source { <6, 14, -8> rgb 1 }
plane { y, 0 pigment { rgb 0.8 } }
prism {
  bezier_spline 0, 0.6, 16,
  <-1, 0>, <-1, 1>, <0, 1>, <0, 0>, <0, 0>, <0, 0>, <-1, 0>, <-1, 0>,
  <1, 0>, <1, 1>, <2, 1>, <2, 0>, <2, 0>, <2, 0.5>, <1.5, 0.5>, <1.5, 0>
  rotate x*-90
  pigment { rgb <1, 0.5, 0> }
}

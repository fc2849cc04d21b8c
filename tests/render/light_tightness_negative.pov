// A tightness below 0: brighter to the rim.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 6, -9> right 4/3*x look_at 0 angle 50 }
light_source {
  <-2.5, 10, 0> rgb .3 spotlight radius 5 falloff 14 tightness -40
  point_at <-2.5, 0, 0>
}
light_source {
  <2.5, 10, 0> rgb .3 cylinder radius 2.2 falloff 2.4 tightness -.5
  point_at <2.5, 0, 0>
}
plane { y, 0 pigment { rgb .8 } }
sphere { <-2.5, .5, 0>, .5 pigment { rgb 1 } }

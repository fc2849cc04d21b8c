// Where a plane and a clear box meet the ray at the same place the plane is
// seen, whichever stands first.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.2, -5> look_at <0, .4, 0> angle 45 }
light_source { <-5, 8, -6>, 1 }
box { <-2, -.5, -1.5>, <-.2, 1, 1> pigment { rgbt 1 } }
plane { y, -.5 pigment { checker rgb .5 rgb .2 } }
box { <.2, -.5, -1.5>, <2, 1, 1> pigment { rgbf <1, .5, .5, 1> } }

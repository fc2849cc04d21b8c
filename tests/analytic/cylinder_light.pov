// A cylinder light: the smooth step is over the distance from the axis, and
// all its rays are parallel to the axis.
// claims: rays path mesh soft
//
// The axis is x = y = 0; radius .5, falloff 1.5, tightness 2. At distance r:
// s = (1.5 - r)/(1.5 - .5), clamped; s^2 (3 - 2s) * (1 - r/1.5)^2; the wall is
// met head on everywhere, so there is no cosine.
//   r = 0: 1      r = .3: .8^2 = .64      r = 1: .5 * (1/3)^2 = .0555556
//   r = .7: .896 * (8/15)^2 = .254862     r = 1.6: 0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <-.05, .05, -10> right 6.4*x up 4.8*y }
light_source { <0, 0, -3>, rgb 1
    cylinder radius .5 falloff 1.5 tightness 2 point_at 0 }
plane { -z, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }

// A parallel light: everywhere from the same side, and faded by the distance
// from the plane of the light, not from its place.
// claims: rays path mesh soft
//
// From <3, 0, -4> to <0, 0, 0>: the cosine on the wall z = 0 is .8. The point
// (x, y, 0) is 5 - .6 x from the light's plane. D = 5, p = 2:
// .8 * 2/(1 + ((5 - .6 x)/5)^2).
//   x = 0: .8      x = 2: .8 * 2/1.5776 = 1.014199
//   x = -3: .8 * 2/2.8496 = .561482, at any y
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <-.05, .05, -10> right 6.4*x up 4.8*y }
light_source { <3, 0, -4>, rgb 1 parallel point_at 0
    fade_distance 5 fade_power 2 }
plane { -z, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }

// A glowing disc over a plane, both black: its form factor.
// claims: path
// options path: --samples 4096
//
// A piece of plane a aside from the axis of a disc of radius r = 1, h below and
// parallel to it, sees it with the form factor
//   F = (1 - (h^2 + a^2 - r^2)/sqrt((h^2 + a^2 + r^2)^2 - 4 a^2 r^2))/2,
// on the axis r^2/(r^2 + h^2). It glows by <1, 2, .5>. The disc is at y = 4.
//   h = 1: .5   h = .1: .990099   h = 4: .058824
//   h = 1, a = 1: .276393         h = 1, a = 2: .052786   h = .5, a = 3: .003633
// Below the axis the light field is 2 (1 - h/sqrt(h^2 + r^2)): .585786 for
// h = 1.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -z }
disc { 4*y, y, 1 pigment { rgb <1, 2, .5> }
  finish { ambient 0 diffuse 0 emission 1 } }
plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 0 } }

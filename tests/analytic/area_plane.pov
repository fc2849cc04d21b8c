// An area light of 4 by 2 over a black wall, half of it behind a screen.
// claims: rays path
// options path: --samples 16384
//
// The light is 4 before the wall, in parallel, without fading. As a true area
// each of its points gives the cosine h/sqrt(x^2 + y^2 + h^2), h = 4, and E is
// the mean. Over the rectangle from 0 to (p, q) the integral of
// 1/sqrt(x^2 + y^2 + h^2) is
//   p asinh(q/sqrt(p^2 + h^2)) + q asinh(p/sqrt(q^2 + h^2))
//     - h atan(p q/(h sqrt(p^2 + q^2 + h^2))),
// and what lies elsewhere is a sum and difference of four of those. The screen
// covers x > .45 half way: from the wall's x on hides the light beyond .9 - x.
//   (-3, 0): .794628, (-3, 2): .738192: all of it is seen
//   x = 1, 0, -1: .418089, .697590, .912067
// POV-Ray's way (rays): the centre's cosine times the share of 17 lamps in a
// row that is seen, those at the ends counting half: .8 and .742781; 7.5/16 *
// .970143 = .454754, 11.5/16 = .71875, 15.5/16 * .970143 = .939826.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -z }
light_source { -4*z, rgb 1 area_light 4*x, 2*y, 17, 9 }
plane { -z, 0 pigment { rgb 1 } finish { ambient 0 diffuse 0 } }
box { <.45, -99, -2.001>, <99, 99, -1.999> pigment { rgb 0 }
  finish { ambient 0 diffuse 0 } }

// brilliance b: cos^b instead of cos; with albedo, times (b + 1)/2.
// claims: rays path mesh soft
//
// A parallel light with cosine .8 on the wall, diffuse .5:
//   b = 3: .5 * .512 = .256    b = 3, albedo: .256 * 2 = .512
//   b = .5: .5 * .894427 = .447214    b = 0: .5
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <-.05, .05, -10> right 6.4*x up 4.8*y }
light_source { <3, 0, -4>, rgb 1 parallel point_at 0 }
#default { pigment { rgb 1 } finish { ambient 0 diffuse .5 } }
box { <-4, 1.2, 0>, <4, 4, 1> finish { brilliance 3 } }
box { <-4, 0, 0>, <4, 1.2, 1> finish { diffuse albedo .5 brilliance 3 } }
box { <-4, -1.2, 0>, <4, 0, 1> finish { brilliance .5 } }
box { <-4, -4, 0>, <4, -1.2, 1> finish { brilliance 0 } }

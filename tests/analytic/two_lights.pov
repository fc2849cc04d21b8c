// Two lights and a bar that hides each from one strip of the wall.
// claims: rays path mesh
//
// Lights <-2, 0, -2> (red) and <2, 0, -2> (green), wall z = 0, diffuse 1. The
// bar spans x = -.3 ... .3, z = -1.2 ... -1. From the green light its edges
// meet the wall at 2 - 1.7*2/1 = -1.4 at the nearest and 2 - 2.3*2/.8 = -3.75
// at the farthest; so from -3.2 to -1.4 there is only red, and by symmetry
// only green from 1.4 on. The bar itself is black and absorbs.
//   (-2, 0): red 1, green 0          (2, 1): green 2/sqrt 5 = .894427, red 0
//   (-1, 0): red 2/sqrt 5, green 2/sqrt 13 = .554700
//   (.8, -1.2): red 2/sqrt(7.84 + 1.44 + 4) = .548821,
//               green 2/sqrt(1.44 + 1.44 + 4) = .762493
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <-.05, .05, -10> right 6.4*x up 4.8*y }
light_source { <-2, 0, -2>, rgb x }
light_source { <2, 0, -2>, rgb y }
plane { -z, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
box { <-.3, -9, -1.2>, <.3, 9, -1> pigment { rgb 0 } finish { ambient 0 diffuse 0 } }

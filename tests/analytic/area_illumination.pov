// area_illumination shades by every lamp, and yet takes the shadow as one
// number: the plain mean of the cosines of the lamps, times the weighted shadow
// of area_light.
// claims: rays mesh soft
//
// The cosine of a lamp k aside is 4/sqrt(16 + k^2): 1, .970143, .894427, .8,
// .707107. Lamps, wall and box are those of area_light.pov.
//   x = 0: (1 + 2 * .970143 + 2 * .894427)/5 * 5/8 = .591142
//   x = -1: (1 + 2 * .970143 + .894427 + .8)/5 * 7/8 = .811075
//   x = -2: (1 + .970143 + .894427 + .8 + .707107)/5 = .874335
// Of light meshes the shadow is 35.5/64 and 51.5/64, as there: .524639 and
// .745899.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <-.05, .05, -10> right 6.4*x up 4.8*y }
light_source { <0, 0, -4>, rgb 1 area_light 4*x, y, 5, 1
    area_illumination }
plane { -z, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
box { <.1, -9, -2.001>, <5, 9, -1.999> pigment { rgb 0 }
    finish { ambient 0 diffuse 0 } }

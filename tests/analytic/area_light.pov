// The soft shadow of an area light in POV-Ray is a weighted mean of its lamps:
// the interval is halved again and again, so 5 lamps in a row count 1/8, 1/4,
// 1/4, 1/4, 1/8. Shading is the centre's.
// claims: rays mesh soft
//
// Lamps at x = -2, -1, 0, 1, 2, z = -4; the wall is z = 0. A black box covers
// x = .1 ... 5 at z = -2, where the ray from lamp l to the point x is at
// (l + x)/2.
//   x = 0: lamps 1 and 2 are hidden: 5/8
//   x = -1: lamp 2: 7/8 * 4/sqrt 17 = .848875
//   x = -2: none: 4/sqrt 20 = .894427
// Light meshes find where the light is cut, to a 64th of its length.
//   x = 0: at .2, 35.2/64, taken for 35.5/64 = .554688
//   x = -1: at 1.2, 51.2/64, taken for 51.5/64: * 4/sqrt 17 = .780662
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <-.05, .05, -10> right 6.4*x up 4.8*y }
light_source { <0, 0, -4>, rgb 1 area_light 4*x, y, 5, 1 }
plane { -z, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
box { <.1, -9, -2.001>, <5, 9, -1.999> pigment { rgb 0 }
    finish { ambient 0 diffuse 0 } }

// A point light before a wall.
// claims: rays path mesh soft many
//
// The light is at <1, 0, -2>, the wall is z = 0. At (x, y) the cosine is
// 2/sqrt((x - 1)^2 + y^2 + 4); the colour is L * pigment * diffuse * cosine
// = <.9, .6, .3> * <1, .5, .25> * .8 * cosine = <.72, .24, .06> * cosine.
//   (1, 0): 1    (-1, 0): 2/sqrt 8 = .707107    (1, 2): .707107
//   (-2, -1): 2/sqrt 14 = .534522    (3, -2): 2/sqrt 12 = .577350
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <-.05, .05, -10> right 6.4*x up 4.8*y }
light_source { <1, 0, -2>, rgb <.9, .6, .3> }
plane { -z, 0 pigment { rgb <1, .5, .25> } finish { ambient 0 diffuse .8 } }

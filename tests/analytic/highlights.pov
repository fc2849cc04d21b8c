// phong and specular: sizes, and the factor of albedo.
// claims: rays path mesh soft many
//
// The view is along z on the wall z = 0; the light is parallel, from
// <3, 0, -4>/5, so n.l = .8, the mirrored view is -z and R.l = .8, and
// h = (l + v)/|l + v| = <.6, 0, -1.8>/sqrt 3.6, so n.h = sqrt .9 = .948683.
// Diffuse is 0. Four strips of y:
//   phong .7, phong_size 3:           .7 * .8^3 = .3584
//   phong albedo .7, phong_size 3:    .3584 * (3 + 1)/2 = .7168
//   specular .5, roughness .25:       .5 * .9^2 = .405 (1/.25 = 4)
//   specular albedo .5, roughness .25: m = 4:
//       .405 * (4 + 2)/(4 (2 - 2^-2)) = .405 * 6/7 = .347143
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <-.05, .05, -10> right 6.4*x up 4.8*y }
light_source { <3, 0, -4>, rgb 1 parallel point_at 0 }
#default { pigment { rgb <.2, .5, .9> } finish { ambient 0 diffuse 0 } }
box { <-4, 1.2, 0>, <4, 4, 1> finish { phong .7 phong_size 3 } }
box { <-4, 0, 0>, <4, 1.2, 1> finish { phong albedo .7 phong_size 3 } }
box { <-4, -1.2, 0>, <4, 0, 1> finish { specular .5 roughness .25 } }
box { <-4, -4, 0>, <4, -1.2, 1> finish { specular albedo .5 roughness .25 } }

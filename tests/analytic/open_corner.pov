// The corner between a plane and an endless black wall of height h = 2 on it,
// under the open sky, seen along the wall's sides. At a distance d from its foot
// the wall takes (1 - d/sqrt(d^2 + h^2))/2 of the sky (the form factor of an
// endless strip, by the crossed strings of Hottel), so that of ambient 0.2 is left
// 0.1 (1 + d/sqrt(d^2 + h^2)): at d = .2 .1100, .5 .1243, 1 .1447,
// 2 .1707, 3 .1832. The lamp is behind the plane.
// claims: mesh path
// options mesh: --mesh-indirect on --mesh-quality 8
// options path: --samples 1024
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <-.05, .05, -10> right 6.4*x up 4.8*y }
light_source { <0, 0, 100> rgb 0.5 }
plane { -z, 0 pigment { rgb 1 } finish { ambient 0.2 diffuse 0.6 } }
box { <-.4, -1000, -2>, <0, 1000, 0> pigment { rgb 0 }
  finish { ambient 0 diffuse 0 } }

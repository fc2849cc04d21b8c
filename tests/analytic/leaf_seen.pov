// The leaf of leaf.pov, seen from above: p (.25 a (L + D) + .5 L).
// claims: path bounced
// options path: --samples 1024
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, 3> look_at 0 right 3.2*x up 2.4*y }
light_source { 9*z, rgb <.2, .4, .6> parallel point_at 0 }
plane { z, 0 pigment { rgb .5 } finish { ambient 0 diffuse 1 } }
plane { z, 2 hollow no_shadow pigment { rgb <.8, .6, .4> }
  finish { ambient 0 diffuse .5, .25 } }
plane { -z, -4 no_shadow pigment { rgb 0 } finish { ambient 0 diffuse 0 } }

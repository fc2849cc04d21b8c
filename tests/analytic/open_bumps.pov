// The plane of open_corner.pov with deep bumps: ambient light isn't any less for
// them.
// claims: mesh path
// options mesh: --mesh-indirect on --mesh-quality 8
// options path: --samples 1024
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <-.05, .05, -10> right 6.4*x up 4.8*y }
light_source { <0, 0, 100> rgb 0.5 }
plane { -z, 0 pigment { rgb 1 } finish { ambient 0.2 diffuse 0.6 }
  normal { gradient y 2 scale .7 sine_wave } }
box { <-.4, -1000, -2>, <0, 1000, 0> pigment { rgb 0 }
  finish { ambient 0 diffuse 0 } }

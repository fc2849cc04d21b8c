// A mirror shows ambient light as well: a small plate that faces an endless
// mirror, which gives back .2, is as open as that.
// claims: path bounced
//
//   ambient .1 * .2 = .02, in white
// options path: --samples 1024
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, .5> look_at z up .075*y right .1*x }
light_source { <0, 0, -10>, rgb 1 }
plane { z, 0 pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection .2 } }
disc { z, z, .1 pigment { rgb 1 } finish { ambient .1 diffuse .6 } }

// Fog of type 1: T = exp(-d/distance), colour * T + fog * (1 - T).
// claims: rays mesh soft
//
// Glowing walls <.9, .3, .6> at z = -5, 0 and 10, that is 5, 10 and 20 before
// the camera; fog <.2, .4, .8>, distance 10: T = .606531, .367879, .135335.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <-.05, .05, -10> right 6.4*x up 4.8*y }
fog { fog_type 1 distance 10 rgb <.2, .4, .8> }
#default { pigment { rgb <.9, .3, .6> } finish { ambient 0 diffuse 0 emission 1 } }
box { <-4, -4, -5>, <-1, 4, -4> }
box { <-1, -4, 0>, <1, 4, 1> }
box { <1, -4, 10>, <4, 4, 11> }

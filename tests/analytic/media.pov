// Even media in front of glowing walls: T = exp(-absorption way), and light of
// its own, emission / absorption (1 - T).
// claims: rays mesh soft path skeleton
// options path: --samples 300
//
// Walls <.9, .3, .6> at z = -5 and 10, that is 5 and 20 before the camera;
// absorption .1, emission .05: T = .606531, .135335.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <-.05, .05, -10> right 6.4*x up 4.8*y }
media { absorption .1 emission <.05, .02, 0> intervals 40 samples 20 density { rgb 1 } }
#default { pigment { rgb <.9, .3, .6> } finish { ambient 0 diffuse 0 emission 1 } }
box { <-4, -4, -5>, <-0, 4, -4> hollow }
box { <0, -4, 10>, <4, 4, 11> hollow }

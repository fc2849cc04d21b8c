// A ball of cloth seen from within, which a lamp lights from outside alone.
// claims: path bounced
// options path: --samples 1024
//
// Of light from behind it sends on b = .4, and of light from before a = .4. In a
// ball each place gets of all others what they send on the mean. The lamp is
// parallel: mean 1/4 of its light on the ball. So e = a e + b / 4, e = 1/6; the
// side that the lamp is not on shows a e = .0667.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location 0 look_at z right .4*x up .3*y }
light_source { <0, 0, -100>, rgb 1 parallel point_at 0 }
sphere { 0, 1 hollow pigment { rgb 1 } finish { ambient 0 diffuse .4, .4 } }

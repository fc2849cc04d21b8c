// A lamp beside the middle of a diffuse unit sphere, fading with the distance.
// claims: rays path bounced
// options path: --samples 16384
//
// fade_distance f = .01 and fade_power 2 make 2 c/(1 + d^2/f^2), with
// c = 1/(2 f^2) = 5000 that is 1/(d^2 + f^2): E0 = cos/(d^2 + f^2).
//   (1,0,0): d = .5, head on: 3.998401        (-1,0,0): d = 1.5: .444425
//   (0,1,0): d^2 = 1.25, cos = 1/d: .715485   (.6,0,.8): .65, .868243: 1.335553
//
// All bounces: inside a sphere any two pieces of wall see each other alike, so
// what is reflected once lights all of it the same: the mean of E0, which is
// 4 pi (what the lamp sends out) over 4 pi (the area) = 1, times the albedo
// a = <.5, .3, .6>; all bounces together a/(1 - a) = <1, .428571, 1.5>. The light
// field at the centre: 3.998401 from the lamp, and four times that.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location 0 }
light_source { .5*x, rgb 5000 fade_distance .01 fade_power 2 }
sphere { 0, 1 pigment { rgb <.5, .3, .6> } finish { ambient 0 diffuse 1 } }

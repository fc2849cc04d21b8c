// A closed sphere that glows everywhere and reflects half, and shines: highlights
// are of lamps, of which there are none, so this is sphere_furnace.pov's light.
// claims: rays path bounced
// options path: --samples 8192 +SC33 +EC34 +SR25 +ER26
//
// L = e/(1 - a) = .3/.5 = .6; with what glows mirrored in highlights it would be
// at least e/(1 - .9) = 3.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <.3, .1, -.2> right 4/3*x angle 100 }
sphere { 0, 1 pigment { rgb 1 }
  finish { ambient 0 emission .3 diffuse .5 phong albedo .4 phong_size 5 } }

// A closed sphere that glows everywhere and reflects half.
// claims: rays path bounced
// options path: --samples 8192 +SC33 +EC34 +SR25 +ER26
//
// Lamps there are none, so rays sees emission * pigment = .3. With light
// followed on, L = e + a L, so L = e/(1 - a) = .3/.5 = .6.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <.3, .1, -.2> right 4/3*x angle 100 }
sphere { 0, 1 pigment { rgb 1 } finish { ambient 0 emission .3 diffuse .5 } }

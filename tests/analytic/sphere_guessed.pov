// A closed sphere that glows, of white paint, whose finish has an ambient term.
// claims: path bounced
// options path: --samples 8192 +SC33 +EC34 +SR25 +ER26
//
// Whoever writes `ambient` has guessed by it what surfaces give each other: they
// send on half of the light, not 0.9 of it. Inside of them no ambient light is.
// So what they send is e + E/2, each gets E = e/(1 - 1/2) = .1/.5 = .2, and is
// seen by e + a E = .1 + .9 * .2 = .28. (Without an ambient term: .1/(1 - .9).)
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <.3, .1, -.2> right 4/3*x angle 100 }
sphere {
  0, 1 pigment { rgb 1 } finish { ambient .1 emission .1 diffuse .9 }
}

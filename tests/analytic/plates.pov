// Two endless plates face to face, of which one glows.
// claims: path bounced
// options path: --samples 16384
//
// A sends out LA = e + a EA, B reflects LB = b EB, EA = LB, EB = LA. So
// LA = e/(1 - a b) and LB = b LA, with e = <.3, .2, .1>, a = <.5, .8, .2>,
// b = <.4, .6, .9>. The light field between them is 2 (LA + LB), anywhere.
// (No skeleton knows a void without end: there rays go on.)
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location z }
plane { z, 0 pigment { rgb <.5, .8, .2> }
  finish { ambient 0 diffuse 1 emission <.6, .25, .5> } }
plane { -z, -2 pigment { rgb <.4, .6, .9> } finish { ambient 0 diffuse 1 } }

// An endless leaf between a grey plate and a black one.
// claims: path bounced
// options path: --samples 16384
//
// The lamp L = <.2, .4, .6> shines down on the leaf at z = 2 and, as it throws no
// shadow, on the plate below, a = .5, which has L + D and sends a of it back up.
// Of colour p = <.8, .6, .4> the leaf sends down D = p (.5 a (L + D) + .25 L), so
// D = p L (.5 a + .25)/(1 - .5 a p), and up p (.25 a (L + D) + .5 L), which is
// what the black plate has.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location 3*z look_at 2*z }
light_source { 9*z, rgb <.2, .4, .6> parallel point_at 0 }
plane { z, 0 pigment { rgb .5 } finish { ambient 0 diffuse 1 } }
plane { z, 2 hollow no_shadow pigment { rgb <.8, .6, .4> }
  finish { ambient 0 diffuse .5, .25 } }
plane { -z, -4 no_shadow pigment { rgb 0 } finish { ambient 0 diffuse 0 } }

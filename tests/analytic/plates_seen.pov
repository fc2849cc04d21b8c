// The plates of plates.pov, seen from between them: above the horizon the one that
// reflects, LB, and below it the one that glows, LA, as bright wherever they are.
// claims: bounced
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location z direction x right 2*y up 1.5*z }
plane { z, 0 pigment { rgb <.5, .8, .2> }
  finish { ambient 0 diffuse 1 emission <.6, .25, .5> } }
plane { -z, -2 pigment { rgb <.4, .6, .9> } finish { ambient 0 diffuse 1 } }

// A wall behind a pane that lets a hundred times the light pass, before another
// that glows by .3.
// claims: path bounced
// options path: --samples 1024
//
// The camera, between the pane and the dark wall, sees .5 of what this gets: no
// more than .3, so .15, for what goes on from surface to surface does not grow.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <.3, .1, 1.5> right 4/3*x angle 60 }
#default { pigment { rgb 1 } finish { ambient 0 diffuse 0 } }
plane { z, 0 finish { emission .3 } }
plane { z, 1 pigment { rgb 0 transmit 100 } }
plane { -z, -2 finish { diffuse .5 } }

// A white disc deep in water, above a floor that glows and below a surface that
// nothing is above: what goes up more flatly than it can leave comes down.
// claims: path bounced
// options path: --samples 1024
//
// Of what arrives from above all is of the floor but what comes from within the
// critical angle, sin^2 = 1/ior^2: e (1 - 1/4), with e = <.6, .3, .9>.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location 100*z look_at 0 right 3.2*x up 2.4*y }
plane { z, -50 pigment { rgb 1 }
  finish { ambient 0 diffuse 0 emission <.6, .3, .9> } }
disc { 0, z, 3 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
plane { z, 50 pigment { rgbf 1 } finish { ambient 0 diffuse 0 }
  interior { ior 2 } }

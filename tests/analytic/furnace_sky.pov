// A room that glows by 1 less its albedo, with a window to a sky that is a
// sphere without shadow.
// claims: path bounced
// options path: --samples 4096
//
// The sky sends out 1, and so do all surfaces, as in furnace.pov: every
// irradiance is 1. What ends the bounces must find the sky through the window,
// though it is nothing that shuts anything in.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -1.5> }
#declare Glows = texture {
  pigment { rgb 1 } finish { ambient 0 diffuse .85 emission .15 }
}
difference {
  box { -2.1, 2.1 }
  box { -2, 2 }
  box { <-1.1, -1.1, -3>, <1.1, 1.1, 0> }
  texture { Glows }
}
sphere { <-1, -1.5, .5>, .5 texture { Glows } }
sphere { 0, 100 hollow no_shadow
  pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 1 } }

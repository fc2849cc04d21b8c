// A furnace: things of all kinds in a room, each glowing by 1 less its albedo.
// claims: path bounced
// options path: --samples 4096
//
// If all surfaces send out 1, each is lit by 1, reflects its albedo a and glows
// by 1 - a: that is 1 again. So every irradiance is 1, inside and outside,
// whatever the shapes, and the light field is 4. (The wedge under the triangle
// is a chamber of its own that the closing skeleton does not know: there further
// rays end the bounces, and bounced loses some.)
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -z }
#macro Glowing(A) pigment { rgb 1 }
  finish { ambient 0 diffuse A emission 1 - A }
#end
box { -2, 2 Glowing(.8) }
sphere { <.5, 0, .2>, .7 Glowing(.7) }
torus { .5, .2 translate <-.8, -1, 0> Glowing(.4) }
cylinder { <-1, 1, -1>, <1, 1.5, 1>, .2 Glowing(.1) }
mesh { triangle { <-2, -2, -2>, <2, -2, 2>, <-2, 0, 2> } Glowing(.95) }

// Light of what glows close to a surface, where mesh points are too far apart to
// know it: a ball over a plane.
// claims: path bounced
// options path: --samples 4096
//
// A ball that glows by 1 lights a place of the plane that sees all of it by
// r^2 h / d^3: r its radius, h the height and d the distance of its middle.
#version 3.7;
global_settings { assumed_gamma 1 ambient_light 0 }
camera { location <0, 4, -8> look_at 0 }
plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse .8 } }
sphere { <0, .2, 0>, .15 pigment { rgb 1 }
  finish { ambient 0 diffuse 0 emission 1 } }

// A black ball of radius 1 that lies on a wall under the open sky, seen from its
// edge: at a place of the wall, d from where it touches, the ball takes
// h R^2 / (d^2 + h^2)^1.5 of the sky (h = R = 1: the form factor of a ball above
// a small plate, Howell, A Catalog of Radiation Heat Transfer Configuration
// Factors). What is left of ambient 0.2 is seen, also where mesh points are so
// far apart that they see past the ball; the picture's grid of corners, four
// pixels apart, is as coarse. The lamp is behind the wall.
//
// The camera looks along <-3, 0, 1>: the centre of pixel (i, j) is at
// x = sqrt(10) (i - 32)/10, y = (24 - j)/10 of the wall.
// claims: mesh path
// options mesh: --mesh-indirect on --mesh-density 1 --mesh-quality 8
// options path: --samples 1024
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Right = <1, 0, 3> / sqrt(10);
camera {
  orthographic
  location 10 * <3, 0, -1> / sqrt(10) - .05 * Right + .05 * y
  direction <-3, 0, 1> / sqrt(10) right 6.4 * Right up 4.8 * y
}
light_source { <0, 0, 100> rgb 0.5 }
plane { -z, 0 pigment { rgb 1 } finish { ambient 0.2 diffuse 0.6 } }
sphere { <0, 0, -1>, 1 pigment { rgb 0 } finish { ambient 0 diffuse 0 } }

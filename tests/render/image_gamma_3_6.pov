// A PNG that says that it is in sRGB is decoded before version 3.7 as well; one
// that says nothing has the scene's own numbers.
// compare: exact
#version 3.6;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -5> right 4*x up 3*y }
#default { finish { ambient 1 diffuse 0 } }
box { <-2, -1.5, 0>, <0, 1.5, .1> pigment { image_map { png "parts/alpha.png" } scale 2 } }
box { <0, -1.5, 0>, <2, 1.5, .1> pigment { image_map { png "parts/flag.png" } scale 2 } }

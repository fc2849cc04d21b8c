// A half space glows, and lights a wall far off. A clear box that ends before the
// wall, as what holds media does, changes nothing, beside its edges either.
// claims: bounced
//
// The half plane x < 0 is 12 away: of what a place of the wall sees it fills
// F = (1 - x/sqrt(x^2 + 144))/2. The wall shows .8 F.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <-.05, .05, -10> right 6.4*x up 4.8*y }
box { <-1e5, -1e5, -12.1>, <0, 1e5, -12>
  pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 1 } }
plane { -z, 0 pigment { rgb .8 } finish { ambient 0 diffuse 1 } }
box { <-2, -1.5, -5>, <2, 1.5, -.02>
  hollow pigment { rgbt 1 } finish { ambient 0 } }

// A half space glows, and a wall far off is lit by it through a clear pane that
// stands close before the wall: in the gap there is no room for mesh points.
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
box { <-50, -50, -.04>, <50, 50, -.02>
  pigment { rgb 1 transmit .999 } finish { ambient 0 } }

// A round patch of a floor is lit in a box that is black but for its floor and,
// a little, its ceiling: nearly all light comes from the patch, which virtual
// lights bring.
// claims: bounced
//
// A lamp of parallel rays lights a disc of radius r = .8 with irradiance 1, and
// the floor sends back all of it. A place of the ceiling, h = 3 above it and a
// beside its axis, sees a share of
//   F = (1 - (h^2 + a^2 - r^2) / sqrt((h^2 + a^2 + r^2)^2 - 4 a^2 r^2)) / 2
// and shows .1 F, a percent of which goes up and down again.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <-.05, .05, -.5> right 6.4*x up 4.8*y }
light_source { <0, 0, -1>, rgb 1
    cylinder radius .8 falloff .8001 tightness 0 point_at <0, 0, -3> parallel }
difference {
  box { <-5, -5, -3.1>, <5, 5, .1> }
  box { <-4, -4, -3.02>, <4, 4, .02> }
  pigment { rgb 0 } finish { ambient 0 diffuse 1 }
}
box { <-4, -4, -3.05>, <4, 4, -3> pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
box { <-4, -4, 0>, <4, 4, .05> pigment { rgb .1 } finish { ambient 0 diffuse 1 } }

// fade_distance and fade_power: 2/(1 + (d/D)^p), d the distance of the light.
// claims: rays path mesh soft
//
// Left wall half: D = 2, p = 2, light <-1.6, 0, -2>; right half: D = 3, p = 1,
// light <1.6, 0, -2>. A box of z <= 0 at x = 0 keeps the halves apart.
//   (-1.6, 0): d = 2, 2/(1 + 1) * 1 = 1
//   (-1.6, 1.5): d = 2.5, cosine .8, 2/(1 + 1.5625) * .8 = .624390
//   (-.6, 0): d = sqrt 5, cosine .894427, 2/(1 + 1.25) * .894427 = .795046
//   (1.6, 0): 2/(1 + 2/3) = 1.2
//   (1.6, -1.5): d = 2.5, 2/(1 + 2.5/3) * .8 = .872727
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <-.05, .05, -10> right 6.4*x up 4.8*y }
light_source { <-1.6, 0, -2>, rgb 1 fade_distance 2 fade_power 2 }
light_source { <1.6, 0, -2>, rgb 1 fade_distance 3 fade_power 1 }
plane { -z, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
box { <-.02, -90, -20>, <.02, 90, 0> pigment { rgb 0 } finish { ambient 0 diffuse 0 } }

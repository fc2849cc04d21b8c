// Brilliance b counts in the light that goes on, too: of lamps' light by cos^b,
// of light from all around by 2/(b + 1), the mean of cos^b over that of cos. A
// floor of albedo p gets light L with cosine .8, and lights a ceiling of albedo q
// that no lamp shines on. They are without end.
// claims: path bounced
//
//   floor  B = p (.8^b L + 2/(b + 1) C),  ceiling  C = q B,  p = q = .5, b = 3:
//   C = .25 (.512 L + .5 C) = .146286 L
// options path: --samples 1024
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, 1> look_at <0, 0, 2> up 2.4*y right 3.2*x }
light_source { <6, 0, 8>, rgb <.2, .4, .6> parallel point_at 0 }
plane { z, 0 pigment { rgb .5 } finish { ambient 0 diffuse 1 brilliance 3 } }
plane { -z, -2 no_shadow pigment { rgb .5 } finish { ambient 0 diffuse 1 } }

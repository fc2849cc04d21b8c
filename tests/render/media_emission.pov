// Media that glow and swallow: densities of patterns, maps and functions,
// several in one object, moved with it; none in what is not hollow.
// compare: exact
// options: +W80 +H60
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, .4, 0> angle 50 }
light_source { <-5, 8, -6> rgb 1 }
plane { y, -1 hollow pigment { checker rgb .8 rgb .4 } }
#default { texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } } }
#declare Fire = density { spherical density_map {
  [0 rgb 0] [.4 agate scale .5 color_map { [0 rgb 0] [1 rgb <1, .5, .2>] }] [1 rgb 2] } }
#declare Smoke = media { absorption <.6, .5, .4> density { gradient y triangle_wave scale .7 } }
sphere { 0, 1 hollow interior { media { emission <.7, .5, .3> density { Fire turbulence .3 } } }
  scale <1, 1.4, 1> rotate 20*z translate -1.8*x }
box { -1, 1 hollow interior { media { Smoke rotate 40*z } media { emission .1
  density { function { x*x + z*z } color_map { [0 rgb 0] [2 rgb 1] } } density { checker density { rgb 1 } density { rgb .3 } scale .5 }
  samples 4 intervals 2 aa_level 4 aa_threshold .05 } }
  scale .8 rotate 30*y translate 1.2*x }
sphere { <0, -.3, -2>, .5 interior { media { emission 1 } } }

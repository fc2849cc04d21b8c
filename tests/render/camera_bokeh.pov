// Focal blur through a lens of a shape: square, and dim at one side.
// compare: noise
// options: +W80 +H60
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -5> look_at 0 right 4/3*x angle 40 aperture 1.6 focal_point 0 blur_samples 200 variance 0
  bokeh { pigment { gradient x color_map { [0 rgb <.2, .1, .1>] [1 rgb <.8, 1, .9>] } } } }
#default { finish { ambient 1 diffuse 0 } }
sphere { <-.8, .6, 4>, .15 pigment { rgb 4 } }
sphere { <1, -.6, 4>, .15 pigment { rgb <4, 2, .5> } }
sphere { <.2, .2, -2>, .1 pigment { rgb <.5, 1, 4> } }
plane { -z, -20 pigment { gradient <1, 2, 0> color_map { [0 rgb .1] [1 rgb .5] } scale 5 } }

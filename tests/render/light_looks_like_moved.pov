// looks_like: its object goes to the light's place before it is modified, so
// that scaling moves it, and textures of the block are where the light is.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -7> look_at <0, 1.6, 0> angle 70 }
#default { finish { emission 1 } }
#declare Bands = pigment {
    gradient y color_map { [0 rgb <.7, .1, .1>] [1 rgb <.9, .9, .3>] } scale .3 }
#declare Ball = sphere { 0, .4 };
light_source { <-1.5, 2.13, -1>, .4
    looks_like { Ball pigment { Bands } scale <1.5, .8, 1> } }
light_source { <.5, 2.13, -1>, .4
    looks_like { Ball pigment { Bands } rotate z*40 } translate .3*x }
light_source { 0, .4 looks_like { Ball translate .2*y pigment { Bands } }
    translate <2.5, 2.13, -1> }
light_source { <0, .6, -1>, .4 looks_like { sphere { 0, .4 pigment { Bands } } } }
plane { y, 0 pigment { checker rgb .9, rgb .5 } finish { emission 0 } }

// The three noise generators, of the scene and of a pattern, in pigments,
// normals, turbulence and functions.
// compare: exact
// options: +W320 +H240
#version 3.7;
global_settings { assumed_gamma 1 noise_generator 3 number_of_waves 4 }
#include "functions.inc"
camera { orthographic location <0, 0, -5> right 4*x up 3*y }
light_source { <0, 0, -100>, rgb 1 parallel point_at 0 }
light_source { <50, 80, -100>, rgb .5 parallel point_at 0 }
#default { finish { ambient 0 diffuse 1 } }
#declare Bozo = function { pattern { bozo noise_generator 1 } };
#macro Row(Y, Generator)
  box { <-2, Y, 0>, <-1.2, Y + 1, .1>
    pigment { granite scale .4
      #if (Generator) noise_generator Generator #end } }
  box { <-1.2, Y, 0>, <-.4, Y + 1, .1>
    pigment { marble turbulence .7 scale .2
      #if (Generator) noise_generator Generator #end
      colour_map { [0 rgb 0] [1 rgb <1, .8, .5>] } } }
  box { <-.4, Y, 0>, <.4, Y + 1, .1>
    pigment { rgb .8 } normal { dents 1 scale .1
      #if (Generator) noise_generator Generator #end } }
  box { <.4, Y, 0>, <1.2, Y + 1, .1>
    pigment { agate scale .4
      #if (Generator) noise_generator Generator #end } }
#end
Row(-1.5, 0)
Row(-.5, 1)
Row(.5, 2)
box { <1.2, -1.5, 0>, <2, -.5, .1>
  pigment { function { f_noise3d(8*x, 8*y, 8*z) } } }
box { <1.2, -.5, 0>, <2, .5, .1>
  pigment { function { f_noise_generator(8*x, 8*y, 8*z, 1) - Bozo(9*x, y, z)/2 } } }
box { <1.2, .5, 0>, <2, 1.5, .1> pigment { waves scale .1 } }

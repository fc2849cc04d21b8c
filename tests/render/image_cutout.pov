// A picture cut out: what is wholly clear keeps its colour, which shows where
// neighbours are mixed, in patterns, bumps and heights. use_alpha of a palette
// without alpha is 0, of colours without alpha how red they are.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.2, -6> look_at <0, .4, 0> angle 45 }
light_source { <-4, 6, -5>, 1 }
#macro Wall(X, Y, P)
  box { 0, <1, 1, .1> pigment { P } finish { emission 1 diffuse 0 }
    translate <X, Y, 1> }
#end
Wall(-2.8, 1, pigment { image_map { png "parts/cutout.png" } })
Wall(-1.65, 1, pigment { image_map { png "parts/cutout.png" interpolate 2 } })
Wall(-.5, 1, pigment { image_map { png "parts/cutout.png" interpolate 3 } })
Wall(.65, 1, pigment { image_map { png "parts/cutout.png" premultiplied on interpolate 2 } })
Wall(1.8, 1, pigment { image_map { function 12, 12 {
    pigment { gradient x color_map { [0 rgb <1, .2, 0>] [.5 rgbt 1] [1 rgbt <.4, .8, 0, .5>] } } }
    interpolate 2 } })
#declare Two = color_map { [0 rgb <1, .3, .2>] [1 rgb <.2, .4, 1>] }
Wall(-2.8, -.1, pigment { image_pattern { png "parts/cutout.png" interpolate 2 } color_map { Two } })
Wall(-1.65, -.1, pigment { image_pattern { png "parts/cutout.png" use_alpha } color_map { Two } })
Wall(-.5, -.1, pigment { image_pattern { png "parts/flag.png" use_alpha } color_map { Two } })
Wall(1.8, -.1, pigment { image_pattern { png "parts/heights_palette.png" use_alpha } color_map { Two } })
box { 0, <1, 1, .1> pigment { rgb .8 } translate <.65, -.1, .9>
  normal { bump_map { png "parts/cutout.png" bump_size 3 interpolate 2 } } }
height_field { png "parts/cutout.png" scale <1.4, .5, 1.4> translate <-1.5, -.4, -1.5>
  pigment { rgb <.8, .7, .5> } }
height_field { png "parts/alpha.png" scale <1.4, .5, 1.4> translate <.1, -.4, -1.5>
  pigment { rgb <.5, .7, .8> } }
plane { z, 3 pigment { rgb <0, .4, .4> } finish { emission 1 diffuse 0 } }

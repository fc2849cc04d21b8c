// EXR and HDR files: colours brighter than 1, premultiplied or said not to be;
// patterns, bumps and heights take the numbers as they are written.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.5, -6> look_at <0, .5, 0> angle 45 }
light_source { <-4, 6, -5>, 1 }
#macro Wall(X, P)
  box { 0, <1, 1, .1> pigment { P } finish { emission 1 diffuse 0 }
    scale <1.3, 1.1, 1> translate <X, .9, 1> }
#end
Wall(-2.8, pigment { image_map { exr "parts/light.exr" transmit all .2 interpolate 2 } })
Wall(-1.4, pigment { image_map { exr "parts/light.exr" premultiplied off interpolate 2 } })
Wall(0, pigment { image_map { hdr "parts/light.hdr" interpolate 2 } })
Wall(1.4, pigment { image_pattern { exr "parts/light.exr" interpolate 2 } })
#macro Block(X, P)
  box { 0, 1 pigment { P } scale <1, .8, .1> translate <X, 0, 0> }
#end
Block(-2.4, pigment { image_pattern { hdr "parts/light.hdr" interpolate 2 } })
Block(-1.2, pigment { image_pattern { exr "parts/light.exr" use_alpha interpolate 2 }
    color_map { [0 rgb <1, .3, .2>] [1 rgb <.2, .4, 1>] } })
Block(0, pigment { image_pattern { png "parts/flag.png" interpolate 3 } })
Block(1.2, pigment { image_pattern { png "parts/alpha.png" use_alpha interpolate 2 }
    color_map { [0 rgb <1, .3, .2>] [1 rgb <.2, .4, 1>] } })
height_field { exr "parts/light.exr" smooth scale <1.6, .5, 1.4>
    translate <-2, -.3, -2> pigment { rgb <.8, .7, .5> } }
height_field { hdr "parts/light.hdr" scale <1.6, .5, 1.4>
    translate <.4, -.3, -2> pigment { rgb <.5, .7, .8> } }
plane { y, -.5 pigment { rgb .7 }
    normal { bump_map { exr "parts/light.exr" bump_size 3 interpolate 2 } rotate x*90 } }

// GIFs: a picture that is a piece of the file's screen and has a clear entry,
// with what may be said of a palette.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -2*z right 4*x up 3*y direction z }
#default { finish { emission 1 diffuse 0 ambient 0 } }
plane { z, 1 pigment { checker rgb <.2, .5, .9> rgb <.9, .8, .1> scale .13 } }
#macro Wall(X, Y, P)
  box { 0, <.9, .9, .1> pigment { P } translate <X, Y, 0> - <2, 1.5, 0> }
#end
Wall(0, 0, pigment { image_map { gif "parts/inset.gif" once } })
Wall(1, 0, pigment { image_map { gif "parts/inset.gif" interpolate 2 } })
Wall(2, 0, pigment { image_map { gif "parts/inset.gif" transmit all .3 } })
Wall(3, 0, pigment { image_map { gif "parts/inset.gif" filter 2 .5 transmit 3 .2 } })
Wall(0, 1, pigment { image_map { gif "parts/inset.gif" filter 1 .5 interpolate 3 } })
Wall(1, 1, pigment { image_map { gif "parts/inset.gif" gamma 1 } })
Wall(2, 1, pigment { image_pattern { gif "parts/inset.gif" interpolate 2 }
  color_map { [0 rgb x] [1 rgb z] } })
Wall(3, 1, pigment { image_pattern { gif "parts/heights.gif" use_alpha }
  color_map { [0 rgb x] [1 rgb z] } })
Wall(0, 2, pigment { image_pattern { gif "parts/inset.gif" use_alpha }
  color_map { [0 rgb x] [1 rgb z] } })
Wall(1, 2, pigment { image_map { gif "parts/heights.gif" } })

// `transmit all` of a picture with a palette stands instead of the transparency
// that its entries have, in the file or by what was said before.
// compare: exact
#version 3.7; global_settings { assumed_gamma 1 }
camera { orthographic location -5*z right 4*x up 3*y }
light_source { <0, 0, -100>, rgb 1 shadowless parallel point_at 0 }
#default { finish { ambient 0 diffuse 1 } }
#macro Pane(X, Y) translate <X * 1.3 - 1.9, Y * 1.4 - 1.35, 0> #end
box { 0, <1, 1, .01> pigment { image_map { png "povmap.png" } } scale 1.2 Pane(0, 0) }
box { 0, <1, 1, .01> pigment { image_map { png "povmap.png" transmit all .4 } } scale 1.2 Pane(1, 0) }
box { 0, <1, 1, .01> pigment { image_map { png "povmap.png" filter all .4 transmit all .3 } } scale 1.2 Pane(2, 0) }
box { 0, <1, 1, .01> pigment { image_map { png "povmap.png" transmit 1, .9 transmit all .3 } } scale 1.2 Pane(0, 1) }
box { 0, <1, 1, .01> pigment { image_map { png "povmap.png" transmit all .3 transmit 1, .9 } } scale 1.2 Pane(1, 1) }
box { 0, <1, 1, .01> pigment { image_map { png "povmap.png" filter 0, .5 filter all .2 } } scale 1.2 Pane(2, 1) }
plane { -z, -1 pigment { checker rgb 1, rgb <.6, .7, .8> scale .31 } }

// warp: repeat, black_hole; several, between other changes, on normals.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -5> right 4*x up 3*y }
light_source { <-3, 4, -6>, 1 }
#default { finish { ambient .3 diffuse .7 } }
box { <-1.95, .05, 0>, <-.7, 1.45, 1> pigment { gradient x color_map { [0 rgb <1, 0, 0>] [1 rgb <0, 1, 1>] }
    scale .7 rotate 30*z warp { repeat .5*x offset <0, .3, 0> flip <0, 1, 0> } scale 1.3 } }
box { <-.65, .05, 0>, <.6, 1.45, 1> pigment { checker rgb 1 rgb <1, 0, 0> scale .15 translate .71*y
    warp { black_hole <.2, .7, 0>, .6 } rotate 10*z } }
box { <.65, .05, 0>, <1.95, 1.45, 1> pigment { checker rgb 1 rgb <0, .5, 0> scale .15 translate .71*y
    warp { black_hole <1.3, .7, 0>, .6 falloff 1.5 strength 2 inverse } } }
box { <-1.95, -1.45, 0>, <-.7, -.05, 1> pigment { gradient y scale .45 warp { repeat .35*y flip y }
    warp { repeat -.5*x flip <1, 1, 0> offset .1*y } rotate 20*z } }
box { <-.65, -1.45, 0>, <.6, -.05, 1> pigment { checker rgb 1 rgb <0, 0, 1> scale .1 translate .01
    warp { black_hole <.3, .1, 0>, .25 falloff 2 strength .8 repeat <.6, .5, 0> } } }
box { <.65, -1.45, 0>, <1.95, -.05, 1> pigment { gradient x } normal { gradient x 1 scale .15
    warp { repeat .25*y flip <1, 0, 0> } rotate 30*z scale <1, 2, 1> warp { black_hole <1.3, -.7, 0>, .4 }
    rotate 30*y } }

// warp: planar, cylindrical, spherical, toroidal, cubic, their orientations, on normals.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -8> right 4/3*x look_at 0 angle 40 }
light_source { <-3, 7, -6>, 1 }
#default { finish { ambient .3 diffuse .7 } }
#declare Lines = pigment { gradient <1, 2, .3> color_map { [0 rgb <.9, .8, .3>] [.5 rgb <.8, .2, .1>] [1 rgb <.1, .2, .6>] } scale .2 }
#declare Tiles = pigment { checker rgb <.9, .85, .7> rgb <.2, .5, .3> scale .1 }
sphere { 0, .8 pigment { Tiles warp { spherical } } translate <-2.4, 1, 0> }
sphere { 0, .8 pigment { Lines warp { spherical orientation y dist_exp 1 } rotate 30*x } translate <-.8, 1, 0> }
cylinder { -.8*y, .8*y, .6 pigment { Lines warp { cylindrical } } rotate 20*x translate <.8, 1, 0> }
cylinder { -.8*y, .8*y, .6 pigment { Tiles warp { cylindrical orientation <1, -2, 1> dist_exp .5 } scale 2 rotate 90*z } rotate -20*x translate <2.4, 1, 0> }
torus { .6, .3 pigment { Tiles warp { toroidal major_radius .6 } } rotate -50*x translate <-2.4, -.8, 0> }
torus { .6, .3 pigment { Lines warp { toroidal orientation x dist_exp 1 } } rotate -50*x translate <-.6, -.8, 0> }
box { -.6, .6 pigment { Lines warp { planar } } rotate 30*y translate <1, -.8, 0> }
box { -.6, .6 pigment { Tiles warp { planar <1, 1, 0>, .13 } } rotate 30*y translate <2.6, -.8, 0> }
sphere { 0, .5 pigment { rgb .8 } normal { gradient y 2 slope_map { [0 <0, 1>] [1 <1, 0>] } scale .1 warp { spherical } } translate <0, -1.4, -2> }
box { -.35, .35 pigment { Lines scale .4 warp { cubic } } rotate <30, 40, 0> translate <1.2, -1.2, -2> }
sphere { 0, .4 pigment { Tiles scale .5 warp { cubic } } translate <-1.2, -1.2, -2> }

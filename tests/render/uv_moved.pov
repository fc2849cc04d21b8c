// What has a surface's own coordinates is moved by what is said beside the pattern
// alone: not by the texture's transformations, nor by those of a declared pigment.
// compare: exact
#version 3.7; global_settings { assumed_gamma 1 }
camera { orthographic location -8*z look_at 0 right 8*x up 6*y }
light_source { <-6, 8, -9> rgb 1 }
#declare C = pigment { checker rgb x rgb y scale .1 }
#declare P = pigment { uv_mapping checker rgb x rgb y scale .1 }
#declare T = texture { uv_mapping pigment { C } }
#declare G = texture { uv_mapping gradient x texture_map { [.5 pigment { rgb x }] [.5 pigment { C }] } scale .2 }
#macro At(X, Y) translate <X * 2 - 3, Y * 2 - 2, 0> #end
sphere { 0, .9 texture { pigment { P } scale .5 } At(0, 0) }
sphere { 0, .9 texture { T scale .5 } At(1, 0) }
sphere { 0, .9 pigment { P scale .5 } At(2, 0) }
sphere { 0, .9 texture { G scale .5 } At(3, 0) }
box { -.6, .6 material { texture { pigment { uv_mapping checker rgb x rgb y scale .1 rotate 30*z } } rotate 40*z } rotate 20 At(0, 1) }
sphere { 0, .9 texture { pigment { rgb 1 } normal { uv_mapping bumps .8 scale .1 } rotate 50*z scale 3 } At(1, 1) }
sphere { 0, .9 texture { pigment { P } normal { bumps .4 scale .2 } scale .3 } At(2, 1) }
sphere { 0, .9 pigment { P } scale .7 rotate 30*z At(3, 1) }

// isosurface: in a box, in a ball, open, with a threshold, in CSG, seen through.
// compare: exact
#version 3.7;
#include "functions.inc"
global_settings { assumed_gamma 1 max_trace_level 10 }
camera { orthographic location <0, 0, -5> right 4*x up 3*y }
light_source { <-3, 4, -6>, 1 }
#default { pigment { rgb .9 } finish { ambient .1 diffuse .7 phong .4 } }
isosurface { function { sqrt(x*x + y*y + z*z) - 1 + .15*sin(x*9)*sin(y*9)*sin(z*9) } max_gradient 3
    contained_by { box { -1.2, 1.2 } } scale .5 translate <-1.3, .7, 0> }
isosurface { function { f_rounded_box(x, y, z, .2, .9, .6, .5) } max_gradient 1.5 rotate <20, 30, 0>
    scale .5 translate .7*y }
isosurface { function { x*x - y*y*.5 - z*z + .2 } max_gradient 6 contained_by { sphere { 0, 1.3 } }
    rotate <20, 30, 0> scale .45 translate <1.3, .7, 0> }
isosurface { function { x*x - y*y*.5 - z*z + .2 } open threshold .1 max_gradient 6
    contained_by { sphere { 0, 1.3 } } rotate <20, 30, 0> scale <.45, .3, .45> translate <-1.3, -.7, 0>
    pigment { gradient x } }
difference { isosurface { function { abs(x) + abs(y) + abs(z) - 1.2 } max_gradient 2
    contained_by { box { -1.2, 1.2 } } } sphere { <.3, .3, -.8>, .6 }
    rotate <20, 30, 0> scale .5 translate -.7*y }
isosurface { function { y + .3*sin(x*4)*cos(z*3) } max_gradient 2
    contained_by { box { <-1, -1, -1>, <1, .3, 1> } } all_intersections accuracy .0005
    rotate <-20, 20, 0> scale .45 translate <1.3, -.7, 0> pigment { rgbt <1, .8, .5, .5> } }

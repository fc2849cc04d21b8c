// A warning where rays would miss the surface, and none where they would not.
#version 3.7;
global_settings { assumed_gamma 1 }
isosurface { function { 8 * (sqrt(x*x + y*y + z*z) - .8) } }
isosurface { function { 8 * (sqrt(x*x + y*y + z*z) - .8) } max_gradient 8 }
isosurface { function { 8 * (sqrt(x*x + y*y + z*z) - .8) } evaluate 1, 2, .9 }
isosurface { function { 8 * (x + y) } }
isosurface { function { y + .3 * sin(9 * x) } max_gradient 1.4 }

// Julia sets whose constant is long: what is larger than 2 is gone, though it
// might come back.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -9> look_at 0 angle 40 }
light_source { <1, 2, -20>, 1 shadowless }
background { rgb .5 }
#default { finish { ambient .2 diffuse .6 } }
julia_fractal { <1.4, .3, 0, 0> quaternion sqr max_iteration 3 precision 1000
    pigment { rgb 1 } rotate 40*y translate <-1.6, 1.2, 0> }
julia_fractal { <-1.6, .3, .4, 0> quaternion cube max_iteration 2 precision 1000
    pigment { rgb <1, .5, .3> } rotate 40*y translate <1.6, 1.2, 0> }
julia_fractal { <2.6, .3, 0, 0> quaternion sqr max_iteration 2 precision 1000
    pigment { rgb <.3, .5, 1> } rotate 40*y translate <-2.2, -1.5, 3> }
julia_fractal { <-2.2, .3, .4, 0> quaternion sqr max_iteration 2 precision 1000
    pigment { rgb <.5, 1, .3> } rotate 40*y translate <1.6, -1.2, 0> }

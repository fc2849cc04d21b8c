// normal_map, slope_map, bump_map, average, a normal for each block.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -5> right 4*x up 3*y }
light_source { <-3, 4, -6>, 1 }
#default { pigment { rgb .9 } finish { ambient .05 diffuse .7 specular .3 } }
#declare Two = normal_map { [.3 gradient x 1 scale .3] [.7 onion 1 scale .4] }
sphere { <-1.5, 1, 0>, .48 normal { gradient y normal_map { Two } scale <.5, .7, .3> rotate 20*x } }
sphere { <-.5, 1, 0>, .48 normal { average normal_map {
    [1 gradient x 1 scale .3] [2 onion .6 scale .4] [quilted 1 scale .5] } scale .6 rotate 30*z } }
sphere { <.5, 1, 0>, .48 normal { gradient x 1
    slope_map { [0 <0, 1>] [.5 <1, 1>] [.5 <1, 0>] [.8 <.2, -1>] [1 <0, 0>] } scale .3 } }
sphere { <1.5, 1, 0>, .48 normal { checker normal { gradient x .7 scale .2 }
    normal { onion .8 scale .3 } scale .4 rotate 20*z } }
sphere { <-1.5, 0, 0>, .48 normal { wood .7 slope_map { [0 <0, 0>] [.5 <1, 0>] [1 <0, 0>] } scale .2 } }
sphere { <-.5, 0, 0>, .48 normal { bump_map { png "parts/flag.png" bump_size 1.5 interpolate 2 }
    scale .6 rotate <10, 20, 30> } }
sphere { <.5, 0, 0>, .48 normal { bump_map { png "parts/heights16.png" map_type 1 bump_size 3
    interpolate 2 } translate .5*x } }
box { <-.4, -.4, -.4>, <.4, .4, .4> normal { bump_map { png "parts/heights_palette.png" once
    use_index bump_size .1 } scale .7 translate -.35 } rotate <-30, 40, 0> translate 1.5*x }
sphere { <-1.5, -1, 0>, .48 pigment { average pigment_map {
    [1 checker rgb 1 rgb <1, 0, 0> scale .2] [2 gradient x color_map { [0 rgb <0, 1, 0>] [1 rgbt <0, 0, 1, .5>] }]
    [1 rgb <1, .5, 0>] } rotate 20*z } }
sphere { <-.5, -1, 0>, .48 texture { average texture_map { [1 pigment { rgb <1, .2, .2> } finish { phong 1 }]
    [1.5 pigment { checker rgb 1 rgb .2 scale .3 } normal { gradient x 1 scale .3 }] } rotate 30*z } }
sphere { <.5, -1, 0>, .48 normal { gradient y normal_map { [0 average normal_map {
    [1 gradient x .5 scale .1] [1 gradient z .5 scale .1] }] [1 bump_map { ppm "parts/tiles.ppm" bump_size 1 }
    scale .3] } scale .5 rotate <10, 20, 5> } }

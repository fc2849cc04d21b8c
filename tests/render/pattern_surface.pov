// slope and aoi: with altitude, to a place, bumped, in maps, of textures; seen
// from within.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 angle 45 }
light_source { <-5, 8, -6>, 1 }
#declare Steep = pigment { slope { y altitude y, -1, 1 }
    color_map { [0 rgb x] [.4 rgb y] [.6 rgb z] [1 rgb 1] } }
#declare Facing = pigment { aoi pigment_map { [.5 rgb x]
    [.8 slope { x } color_map { [0 rgb 0] [1 rgb <1, 1, 0>] }] [1 rgb 1] } }
sphere { <-1, 0, 0>, .8 pigment { Steep } rotate 20*z scale <1, 1.2, 1> }
torus { .5, .3
    texture { pigment { Facing } normal { bumps 1 scale .2 }
        finish { ambient .5 } }
    rotate -60*x translate x }
plane { y, -1.2 texture { slope { point_at <0, 5, 0> } texture_map {
    [0 pigment { rgb 1 }] [.5 pigment { rgb <0, .5, .5> }]
    [1 pigment { rgb 1 } ] } } }
box { <-.4, -1, 1>, <.4, 1, 1.2> pigment { slope { -z, .2, .9 } scale 3
    color_map { [0 rgb x] [.5 rgb y] [1 rgb 1] } } rotate 30*y }
smooth_triangle { <-2, 1, 0>, <-1, 1, -1>, <-1, 1, 0>, <1, 0, -1>,
    <-1.5, 2, 0>, <0, 1, -1>
    pigment { slope -y color_map { [0 rgb 0] [.2 rgb x] [.8 rgb 1] } } }

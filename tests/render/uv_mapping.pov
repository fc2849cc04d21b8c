// uv_mapping: pigments, normals, textures and objects; spheres, boxes, tori,
// lathes, surfaces of revolution, patches, meshes, shapes that have none.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -9> right 4/3*x look_at <0, 0, 0> angle 42 }
light_source { <-6, 9, -8>, rgb 1 }
background { rgb <.25, .3, .4> }
#declare Tiles = pigment { checker rgb <.9, .8, .5>, rgb <.3, .2, .6> scale 1/12 }
#declare Slant = pigment { gradient <1, 2, 0> scale .25
    color_map { [0 rgb <1, .5, .1>] [.5 rgb <.1, .6, .3>] [1 rgb <.2, .2, .8>] } }
#declare T_Slant = texture { pigment { uv_mapping Slant } }
#declare T_Tiles = texture { pigment { uv_mapping Tiles } }
#declare T_All = texture { uv_mapping pigment { Slant } }
sphere { <0, 0, 0>, .9 pigment { uv_mapping Tiles } rotate <20, 40, 0>
    translate <-3.2, 1.3, 0> }
sphere { .2*x, .8 texture { uv_mapping pigment { Slant }
    normal { gradient x 2 slope_map { [0 <0, 1>] [1 <1, 0>] } scale .1 } finish { phong .6 } }
    rotate 30*z scale <1, 1.1, 1> translate <-1.1, 1.3, 0> }
box { <-.8, -.7, -.6>, <.7, .7, .7> uv_mapping
    pigment { Slant scale 2 } rotate <-20, 30, 0> translate <1, 1.3, 0> }
torus { .7, .3 texture { uv_mapping checker texture { pigment { rgb <.8, .3, .2> } }
    texture { pigment { rgb <.9, .9, .7> } finish { phong .5 } } scale 1/8 }
    rotate -50*x translate <3.1, 1.3, 0> }
lathe { cubic_spline 6, <.1, -1.2>, <.2, -1>, <1, -.8>, <.5, .5>, <.3, 1>, <.2, 1.2>
    pigment { uv_mapping Slant } scale .8 translate <-3.2, -.9, 0> }
sor { 6, <.1, -1.2>, <.2, -1>, <1, -.8>, <.5, .5>, <.4, 1>, <.2, 1.2>
    pigment { uv_mapping Tiles translate .02*y } scale .8 rotate -30*x translate <-1.3, -.9, 0> }
bicubic_patch { type 1 flatness 0 u_steps 3 v_steps 3
    uv_vectors <0, 0> <1, .1> <.9, 1.2> <.1, 1>
    <-1, -1, 0>, <-.5, -1, -1>, <.5, -1, 1>, <1, -1, 0>
    <-1, -.5, 0>, <-.5, -.5, 0>, <.5, -.5, 0>, <1, -.5, 0>
    <-1, .5, 0>, <-.5, .5, -.6>, <.5, .5, .4>, <1, .5, 0>
    <-1, 1, 0>, <-.5, 1, 0>, <.5, 1, 0>, <1, 1, 0>
    uv_mapping texture { pigment { Tiles } } scale .7 translate <.5, -1, 0> }
mesh {
    triangle { <-1, -1, 0>, <1, -1, 0>, <-1, 1, 0> uv_vectors <0, 0>, <1, .1>, <.2, 1> }
    smooth_triangle { <1, -1, 0>, -z, <1, 1, .3>, -z + .3*x, <-1, 1, 0>, -z
        uv_vectors <1, .1>, <1, 1>, <.2, 1> texture { T_Slant } }
    triangle { <1, -1, 0>, <1.3, -1, 0>, <1.3, 1, 0> }
    pigment { uv_mapping Tiles } scale .5 translate <2.1, -1.3, 0> }
mesh2 {
    vertex_vectors { 4, <-1, -1, 0>, <1, -1, 0>, <1, 1, 0>, <-1, 1, 0> }
    uv_vectors { 5, <0, 0>, <1, 0>, <1, 1>, <0, 1>, <.5, .5> }
    texture_list { 2, texture { T_Tiles }, texture { T_All } }
    face_indices { 2, <0, 1, 2>, 0, <0, 2, 3>, 1 }
    uv_indices { 2, <0, 1, 4>, <0, 2, 3> }
    scale .5 translate <3.4, -1.3, 0> }
cylinder { -.3*x, .6*x, .4 pigment { uv_mapping Tiles } translate <2.7, -.3, 0> }
difference {
    plane { y, -2 }
    sphere { <0, -2, -2>, .7 }
    sphere { <1.6, -2, -2>, .6 pigment { uv_mapping Tiles } }
    pigment { rgb .7 }
}
#declare Steps = normal { gradient <1, 2, 0> 2
    slope_map { [0 <0, 1>] [1 <1, 0>] } scale .1 }
sphere { 0, .35 normal { uv_mapping Steps } pigment { rgb .8 } rotate 60*z
    scale <1, 1.2, 1> translate <-.4, -1.5, -2.5> }
sphere { 0, .35 uv_mapping normal { Steps } pigment { rgb .8 } rotate 60*z
    translate <.5, -1.6, -2.8> }
union {
    sphere { <-2, -2, -2>, .5 }
    box { <-1.4, -2, -2.3>, <-.9, -1.6, -1.8> }
    pigment { uv_mapping Slant }
}
sphere { <3, -1.6, -2>, .4 pigment { uv_mapping checker rgbt 1, rgb <.8, .9, .3> scale 1/10 } }

// Textures of a blob's parts, of a triangle's corners, of a picture's numbers,
// and of tiles.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -7> look_at 0 angle 40 }
light_source { <-5, 8, -6>, 1 }
#default { finish { ambient .2 } }
blob {
    threshold .4
    sphere { <-.5, 0, 0>, 1, 1 pigment { rgb x } }
    cylinder { <.5, 0, 0>, <1, .5, .4>, .7, 1
        texture { pigment { checker rgb y rgb 1 scale .2 } rotate 30 }
        finish { phong .5 } rotate 5 * z }
    sphere { <0, .6, 0>, .8, -.5 pigment { rgb z } }
    component .8 .7 <0, -.5, -.2>
    pigment { granite scale .3 }
    translate <-1.2, .8, 0>
}
#declare A = texture { pigment { rgb x } finish { phong 1 } }
#declare B = texture { pigment { rgb y } }
#declare C = texture { pigment { checker rgb z rgb 1 scale .1 } }
mesh {
    triangle { <-1, 0, 0>, <1, 0, 0>, <0, 1, 0> texture_list { A B C } }
    triangle { <-1, 0, 0>, <1, 0, 0>, <0, -1, 0> texture_list { A, B A } }
    translate <1.2, 1, 0>
}
mesh2 {
    vertex_vectors { 4, <-1, -.5, 0>, <1, -.5, 0>, <1, .5, 0>, <-1, .5, 0> }
    texture_list { 3, texture { A } texture { B } texture { C } }
    face_indices { 2, <0, 1, 2>, 0, 1, 2, <0, 2, 3>, 1, 1, 1 }
    translate <-1.2, -1, 0>
}
box { -1, 1
    texture {
        material_map { png "parts/heights_palette.png" interpolate 0 once
            texture { A } texture { B } texture { C } }
        scale 1.5 translate -.7
    }
    scale .7 translate <1.2, -1, 0>
}
sphere { 0, .6
    texture {
        uv_mapping
        material_map { png "parts/heights_palette.png" interpolate 0
            texture { A } texture { B } texture { C } }
    }
    translate <0, -1.2, -1.6>
}
plane { y, -2 texture { tiles { texture { A } tile2 texture { B } } scale .4 } }

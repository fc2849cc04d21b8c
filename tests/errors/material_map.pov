#version 3.7;
sphere { 0, 1 texture { material_map { "parts/none.png" } } }
sphere { 0, 1 texture { tiles { texture { } texture { } } } }
mesh { triangle { 0, x, y texture_list { 5 } } }
mesh2 { vertex_vectors { 3, 0, x, y } texture_list { 1, texture { pigment { rgb 1 } } } face_indices { 1, <0, 1, 2>, 0, 0, 1 } }
sphere { 0, 1 cutaway_textures on }

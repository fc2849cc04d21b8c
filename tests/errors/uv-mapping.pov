sky_sphere { pigment { uv_mapping bozo } }
#declare F = function { pigment { uv_mapping bozo } }
sphere { 0, F(0, 0, 0).red }
mesh2 { vertex_vectors { 3, 0, x, y } face_indices { 1, <0, 1, 2> }
    uv_vectors { 1, <0, 0> } uv_indices { 1, <0, 1, 2> } }
mesh2 { vertex_vectors { 3, 0, x, y } uv_vectors { 1, <0, 0> } uv_indices { 1, <0, 0, 0> } }
mesh { triangle { 0, x, y uv_vectors <0, 0>, <1, 0> } }
bicubic_patch { uv_vectors <0, 0>, <1, 1> 0 }

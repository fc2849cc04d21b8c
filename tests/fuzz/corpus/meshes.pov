#version 3.7; global_settings { assumed_gamma 1 }
#declare T = texture { pigment { rgb <1, 0, 0> } finish { phong 1 } }
mesh {
    triangle { 0, x, y texture { T } uv_vectors <0, 0>, <1, 0>, <0, 1> }
    smooth_triangle { 0, -z, x, -z, y, -z }
    inside_vector y pigment { rgb 1 }
}
mesh2 {
    vertex_vectors { 4, 0, x, y, <1, 1, 0.5> }
    normal_vectors { 4, -z, -z, <0.1, 0, -1>, -z }
    uv_vectors { 4, <0, 0>, <1, 0>, <0, 1>, <1, 1> }
    texture_list { 2, texture { T } texture { pigment { rgb 0.5 } } }
    face_indices { 2, <0, 1, 2>, 0, <1, 2, 3>, 1 }
    normal_indices { 2, <0, 1, 2>, <1, 2, 3> }
    uv_indices { 2, <0, 1, 2>, <1, 2, 3> }
    inside_vector <0, 0, 1> scale 2
}

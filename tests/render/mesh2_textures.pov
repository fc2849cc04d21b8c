// mesh2: texture_list, a texture for a face, and normals numbered apart from
// the vertices.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> right 4/3*x look_at <0, .9, 0> angle 45 }
light_source { <-3, 5, -8>, rgb 1 }
background { rgb .2 }
#declare Red = texture { pigment { rgb <.9, .2, .2> } }
#declare Green = texture { pigment { rgb <.2, .8, .2> } }
#declare Blue = texture { pigment { rgb <.2, .3, .9> } finish { phong .8 } }
mesh2 {
    vertex_vectors {
        4, <-2.4, 0, 0>, <-.3, 0, 0>, <-.5, 1.8, 0>, <-2.2, 1.9, 0> }
    texture_list { 2, texture { Red } texture { Blue } }
    face_indices { 2, <0, 1, 2>, 0, <0, 2, 3>, 1 }
}
mesh2 {
    vertex_vectors { 4, <.3, 0, 0>, <2.4, 0, 0>, <2.2, 1.8, 0>, <.5, 1.9, 0> }
    normal_vectors { 3, <-1, .3, -2>, <1, .3, -2>, <0, 1, -1.5> }
    texture_list { 3, texture { Red } texture { Green } texture { Blue } }
    face_indices { 2, <0, 1, 2>, 2, <0, 2, 3>, 1 }
    normal_indices { 2, <0, 1, 2>, <0, 2, 2> }
}

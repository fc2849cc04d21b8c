// mesh_camera: back at the places of a mesh's own coordinates, smoothly.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Skin = mesh2 {
    vertex_vectors { 5, <-1, -1, 0>, <1, -1, 0>, <1, 1, 0>, <-1, 1, 0>, <0, 0, -1> }
    normal_vectors { 5, <-1, -1, -1>, <1, -1, -1>, <1, 1, -1>, <-1, 1, -1>, <0, 0, -1> }
    uv_vectors { 5, <0, 0>, <1, 0>, <1, 1>, <0, 1>, <.5, .4> }
    face_indices { 4, <0, 1, 4>, <1, 2, 4>, <2, 3, 4>, <3, 0, 4> }
}
camera {
    mesh_camera { 1 3 mesh { Skin } smooth }
    location <0, 0, .01> direction -z
}
light_source { <-5, 8, -6>, 1 }
object { Skin pigment { checker rgb x rgb 1 scale .3 translate <.11, .13, .07> } no_shadow }

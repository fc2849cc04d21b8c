#version 3.7;
#declare M = mesh { triangle { 0, x, y } }
camera { mesh_camera { 0 0 mesh { M } } }
camera { mesh_camera { 2 0 mesh { M } } }
camera { mesh_camera { 1 4 mesh { M } } }
camera { mesh_camera { 2 3 mesh { M } mesh { M } } }
camera { mesh_camera { 1 0 mesh { M } smooth } }
camera { mesh_camera { 1 0 } }
camera { cylinder 5 }

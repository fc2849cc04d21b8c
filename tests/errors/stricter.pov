/* What POV-Ray refuses, too. */
#declare A = array[3] { 1, "a", x };
#declare B = array[2];
#declare B[0] = x;
#declare B[1] = <1, 2>;
#declare C = array[2] { array[1] { 1 }, 3 };
#declare D = array[2] { array[1] { 1 }, array[1] { "s" } };
#declare D[0][0] = "text";
sphere { 0, 1 pigment { gradient y color_map { [0 rgb 0], [1 rgb 1] } } }
sphere { 0, 1 pigment { gradient y pigment_map { [0 rgb 0] [1 rgb 1], } } }
sphere { 0, 1 texture { gradient y texture_map { [0 pigment { rgb 0 }], } } }
sphere { 0, 1 normal { gradient y slope_map { [0 <0, 1>], [1 <1, 1>] } } }
sphere { 0, 1 normal { gradient y normal_map { [0 bumps], [1 dents] } } }
mesh2 { vertex_vectors { 3, 0, x, y } }
mesh2 { pigment { rgb 1 } }
mesh2 { vertex_vectors { 3, 0, x, y } face_indices { 0 } }
mesh { }

// Names with and without brackets, and what begins a shape.
#declare A = 1;
#undef (A)
#fclose (F)
#ifndef A #end
isosurface { x*x + y*y - 1 }
sphere_sweep { 2, 0, 1, x, 1 }
sphere { 0, 1 matrix { 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0 } }
mesh2 { vertex_vectors { <0, 0, 0>, <1, 0, 0>, <0, 1, 0> } face_indices { 1, <0, 1, 2> } }

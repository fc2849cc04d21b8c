#version 3.7;
sphere_sweep { 4, <0,0,0>, 1 }
sphere_sweep { b_spline 2, <0,0,0>, 1, <1,0,0>, 1 }
sphere_sweep { linear_spline 1, <0,0,0>, 1 }
sphere_sweep { linear_spline 2000000000, <0,0,0>, 1 }
sphere_sweep { linear_spline 2, <0,0,0>, 1 pigment { rgb 1 } }
sphere { 0, 1 pigment { slope { point_at y altitude y } } }
sphere { 0, 1 pigment { slope { y, 0 } } }
sphere { 0, 1 pigment { image_pattern { "parts/none.png" use_index } } }

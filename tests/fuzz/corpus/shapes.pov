#version 3.7;
camera { mesh_camera { 1 0 mesh { triangle { 0, x, y } } } location <0, 0, .1> normal { bumps .1 } }
#declare T = texture { pigment { rgb 1 } }
parametric { function { u } function { v } function { u*v } <0, 0>, <1, 1> contained_by { sphere { 0, 1 } } precompute 9 x, y, z accuracy .1 texture { T } }
julia_fractal { <.1, .2, .3, .4> hypercomplex pwr(2, 1) slice <0, 0, 0, 1>, .1 max_iteration 3 precision 9 texture { T } }
blob { threshold .5 sphere { 0, 1, 1 pigment { rgb x } } cylinder { 0, x, 1, 1 texture { T } translate y } }
mesh { triangle { 0, x, y texture_list { T T T } } }
mesh2 { vertex_vectors { 3, 0, x, y } texture_list { 1, texture { T } } face_indices { 1, <0, 1, 2>, 0, 0, 0 } }
difference { sphere { 0, 1 texture { T } } box { 0, 1 } cutaway_textures }
sphere { 0, -1 texture { tiles { texture { T } tile2 texture { T } } scale 2 } }
torus { 1, -.2 texture { T normal { facets size .2 coords 1 no_bump_scale } } }
sphere { 0, 1 pigment { wood warp { black_hole 0, 1 repeat 2 turbulence .5 } } }
bicubic_patch { flatness .1 0, x, 2*x, 3*x, y, 1, 1, 1, 2*y, 1, 1, 1, 3*y, 1, 1, 1 }

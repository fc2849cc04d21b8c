// interior_texture: of a smooth triangle the normals say which side is outside,
// whichever way its corners turn; of a flat one its corners.
// compare: exact
#version 3.7; global_settings { assumed_gamma 1 }
camera { orthographic location -5*z right 8*x up 6*y }
light_source { <-3, 5, -9>, rgb 1 }
#default { finish { ambient .3 } }
#macro Two(X, Y) pigment { rgb x } interior_texture { pigment { rgb y } } translate <X * 2 - 3, Y * 2 - 2, 0> #end
#declare A = <-.9, -.8, 0>; #declare B = <.9, -.8, 0>; #declare C = <0, .8, 0>;
#macro Bent(N) N, B, N + .2*x, C, N + .3*y #end
#macro Back(N) N, C, N + .3*y, B, N + .2*x #end
smooth_triangle { A, Bent(-z) Two(0, 0) }
smooth_triangle { A, Bent(z) Two(1, 0) }
smooth_triangle { A, Back(-z) Two(2, 0) }
smooth_triangle { A, Back(z) Two(3, 0) }
mesh { smooth_triangle { A, Bent(-z) } Two(0, 1) }
mesh { smooth_triangle { A, Bent(z) } Two(1, 1) }
mesh { smooth_triangle { A, Back(-z) } Two(2, 1) }
mesh { smooth_triangle { A, Back(z) } Two(3, 1) }
triangle { A + <-3, 2, 0>, B + <-3, 2, 0>, C + <-3, 2, 0> pigment { rgb x } interior_texture { pigment { rgb y } } }
triangle { A + <-1, 2, 0>, C + <-1, 2, 0>, B + <-1, 2, 0> pigment { rgb x } interior_texture { pigment { rgb y } } }
mesh { triangle { A, B, C } Two(2, 2) }
mesh { triangle { A, C, B } Two(3, 2) }

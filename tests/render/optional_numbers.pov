// Numbers that may be missing, given as elements, calls and components; colours
// of a map that begin as the numbers of old maps do; vectors of a mesh2 that are
// worked out; colours that are elements of five numbers.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -7> look_at <0, .4, 0> angle 45 }
light_source { <-4, 6, -5>, 1 }
#declare K = .5;
#declare A = array[2] { 0, 1 }
#declare V = <0, .3, 1>;
#declare C = rgb <1, .5, 0>;
#declare F = function(x) { x - 1 }
#declare S = spline { 0, 0 1, x }
#declare Faces = array[2] { <0, 1, 2>, <0, 2, 3> }
sphere { <-2.4, 1.2, 0>, .6
  pigment { gradient y color_map { [A[0] K*C] [K, 1 - C] [1 (C + 1)/2] } } }
sphere { <-.8, 1.2, 0>, .6
  pigment { gradient x color_map { [0 K color C color C*2] [K A[1] color C*.2 color C] } } }
sphere { <.8, 1.2, 0>, .6
  pigment { average pigment_map { [A[1] rgb V] [F(3) gradient y] [V.y C] } } }
sphere { <2.4, 1.2, 0>, .6 pigment { slope { y V.x, V.z } }
  finish { reflection { A[0] V.y fresnel F(1) } diffuse V.z V.y } }
mesh2 {
  vertex_vectors { 4, <-5.6, -.8, 0>*K, <-1.4, -.4, -.3>, <-1.4, 0, 0> + .4*y, <-2.8, .4, 0> }
  texture_list { 2, texture { pigment { C } } texture { pigment { rgb V } } }
  face_indices { 2, Faces[0], mod(3, 2), Faces[1], A[0] }
}
difference { sphere { <0, -.1, 0>, .6 } box { <-1, 0, -1>, 1 } hollow vlength(V)
  pigment { rgbt <1, 1, 1, .6> } interior { media { emission <.2, .5, 1> samples A[1]*3, F(4) method 3 } } }
sphere { <1.6, 0, 0>, .6 hollow S(1).x pigment { rgbt <1, 1, 1, .6> }
  interior { media { emission <.2, .8, .1> samples 3 method 3 } } }
sphere { <2.7, 0, -.5>, .5 hollow vrotate(x, y).y pigment { rgbt <1, .4, 1, .6> }
  interior { media { emission <.9, .1, .1> samples 3 method 3 } } }
#declare Fives = array[1] { <.8, .9, 1, 0, 0> }
plane { y, -.7 pigment { Fives[0]*.6 } }

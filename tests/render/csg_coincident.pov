// Surfaces in one place: in an intersection, a merge or a clipped union the
// last part is seen, in a union the first.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -9> right 4/3*x look_at 0 angle 45 }
light_source { <-5, 8, -6> rgb 1 shadowless }
#declare A = plane { -z, .5 pigment { rgb x } }
#declare B = plane { -z, .5 pigment { rgb y } }
#declare C = plane { -z, .5 pigment { rgb z } }
#declare Part = cylinder { -z, 0, .9 }
#macro At(I, J) translate <2.2*(I - 1), 2.2*(.5 - J), 0> #end
intersection { object { A } object { B } object { Part } At(0, 0) }
merge { object { A clipped_by { Part } } object { C clipped_by { Part } } At(1, 0) }
union { object { A } object { B } object { C } clipped_by { Part } At(2, 0) }
union { object { A clipped_by { Part } } object { B clipped_by { Part } } At(0, 1) }
intersection {
  merge { object { C } object { A } } object { B } object { Part } At(1, 1)
}
merge {
  intersection { object { Part } object { A } }
  intersection { object { Part } object { C } } At(2, 1)
}

#version 3.7;
global_settings { assumed_gamma 1 }
// min_extent and max_extent of what is clipped, bounded or without end.
#macro Show (T)
  #debug concat(vstr(3, min_extent(T), ",", 0, 2), " ", vstr(3, max_extent(T), ",", 0, 2), "\n")
#end
#declare A = sphere { 0, 1 clipped_by { plane { -x, 0 } } } Show(A)
#declare A = sphere { 0, 1 clipped_by { box { -.5, .5 } } } Show(A)
#declare A = intersection { sphere { 0, 1 } plane { y, .2 clipped_by { sphere { 0, 1 } } } } Show(A)
#declare A = plane { y, .2 } Show(A)
#declare A = plane { y, .2 bounded_by { sphere { 0, 1 } } } Show(A)
#declare A = intersection { plane { x, 1 } plane { -x, 1 } plane { y, 1 } plane { -y, 1 } plane { z, 1 } } Show(A)
#declare A = intersection { object { A } plane { z, 1 inverse } } Show(A)
#declare A = intersection { union { plane { x, 1 } plane { x, .5 } } sphere { 0, 3 } } Show(A)
#declare A = intersection { plane { x, 1 rotate 90*z } sphere { 0, 3 } } Show(A)
#declare A = difference { sphere { 0, 3 } plane { x, 1 } } Show(A)
#declare A = union { sphere { 0, 2 } plane { y, 0 } } Show(A)
#declare A = sor { 4, <.3, 0>, <.4, .2>, <.6, .6>, <.3, 1> } Show(A)
#declare A = sor { 5, <.3, 0>, <.4, .2>, <.8, .5>, <.3, 1>, <.2, 1.1> } Show(A)

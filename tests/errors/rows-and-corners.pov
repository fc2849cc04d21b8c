#declare A = array[2][2] {1, 2, 3, 4}
#declare B = array[2][2][2] {{1, 2}, {3, 4}}
mesh { <0, 0, 0>, <1, 0, 0>, <0, 1, 0> }
mesh { triangle { <0, 0, 0>, <1, 0, 0> } }
triangle { <0, 0, 0> }
smooth_triangle { 0, y, x, y }
polygon { <0, 0>, <1, 0>, <1, 1> }
blob { sphere { 0, 1 } }
blob { cylinder { 0, y, 1 } }
isosurface { function { x } contained_by { cube { -1, 1 } } }

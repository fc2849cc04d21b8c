#version 3.7;
#declare Leaf = texture { pigment { rgb <0, 1, 0> } }
mesh {
    triangle { <0, 0, 0>, <1, 0, 0>, <0, 1, 0> texture { Leaf } }
    triangle { <0, 0, 0>, <1, 0, 0>, <0, 1, 1> texture { Leav } }
    triangle { <0, 0, 0>, <1, 0, 0>, <0, 1, 2> texture { Leaf } }
}

sor { 3, <0, 0>, <1, 1>, <1, 2> }
sor { 4, <0, 0>, <1, 2>, <1, 1>, <1, 3> }
sor { 4, <0, 0>, <1, 1>, <1, 2>, <1, 1> }
sor { 4, <0, 0>, <1, 1>, <1, 2>, <1, 3> opne }
bicubic_patch { u_steps 30 v_steps 2 x, y, z }
bicubic_patch { u_steps 2 v_steps 2, <0, 0, 0>, <1, 0, 0> }
bicubic_patch { typ 1 }

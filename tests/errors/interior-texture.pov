sphere { 0, 1 interior_texture { pigment { rgb 1 } } }
#declare M = material { interior_texture { pigment { rgb 1 } } }

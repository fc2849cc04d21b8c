sphere { <0,0,0>, Radius pigment { rgb 1 } }

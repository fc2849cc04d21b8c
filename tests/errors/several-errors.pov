sphere { 0, Raduis }
box { <0,0,0>, <1,1,1> pigmnt { rgb 1 } }
cylinder { 0, y, 1 texture { T_Wood99 } }

sphere { <0,0,0>, 1 pigmnt { rgb 1 } }

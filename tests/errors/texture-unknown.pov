sphere { 0, 1 texture { pigment { checker rgb 1 rgb 0 } finish { phnog 1 } } }

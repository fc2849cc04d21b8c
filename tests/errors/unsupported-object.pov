sphere { 0, 1 pigment { gradient x slope_map { [0 <0, 1>] } } }

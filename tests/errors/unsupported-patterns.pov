sphere { 0, 1 pigment { gradient x normal_map { [0 bumps] [1 dents] } } }

#declare Shell = pigment { gradient x normal_map { [0 bumps] [1 dents] } }
sphere { 0, 1 }
sphere { 0, 1 pigment { Shell } }

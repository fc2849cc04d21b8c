radiosity { count 100 }
sphere { 0, 1 }
photons { count 20000 }
#declare Shell = pigment { gradient x normal_map { [0 bumps] [1 dents] } }
sphere { 0, 1 pigment { Shell } }
sphere { 0, 1 pigment { gradient x slope_map { [0 <0, 1>] } } }
sphere { 0, 1 pigment { gradient x texture_map { [0 pigment { rgb 1 }] } } }
light_source { 5, 1 spot point_at 0 }

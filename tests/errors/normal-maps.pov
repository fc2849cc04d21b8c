sphere { 0, 1 normal { average } }
sphere { 0, 1 pigment { average } }
sphere { 0, 1 normal { checker normal_map { [0 bumps 1] } } }
sphere { 0, 1 normal { bumps normal_map { } } }
sphere { 0, 1 normal { bumps normal_map { [wood] } } }
sphere { 0, 1 normal { hexagon normal { bumps } normal { dents } normal { dents } normal { bumps } } }
sphere { 0, 1 normal { bumps slope_map { [0 1] [1 "up"] } } }
sphere { 0, 1 normal { bump_map { png "../render/parts/flag.png" bump_sise 1 } } }
sphere { 0, 1 texture { average texture_map { #for (I, 1, 33) [1 pigment { rgb I }] #end } } }
#declare N = normal { bumps };
#for (I, 1, 11) #declare N = normal { bumps normal_map { [0 N] [1 N] } } #end

#declare V = <1, 2, 3>;
camera { location 0, 0, -5 look_at 0 }
sphere { 0, 1 translate 1 2 3 }
sphere { 0, 1 scale 2, 1, 1 }
sphere { 0, 1 rotate y 90 }
sphere { 0, 1 rotate 30*deg }
sphere { 0, 1 rotate 30*degrees*y }
sphere { 0, 1 finish { reflection 0, 1 } }
sphere { 0, 1 finish { diffuse rgb 0.5 } }
light_source { 0 color 1 1 1 }
light_source { color rgb 1 location <1, 2, 3> }
sphere { 0, V.0 }
sphere { 0, V(1) }
#debug 3

#macro NameA, B)
  sphere { A, B }
#end
#macro Ring [R, T]
  torus { R, T }
#end
NameA(1, 2)
Ring(1, 2)

#declare Ball = sphere { 0, 1 }
#macro Show(Figure, Where
  object { Figure translate Where }
#end
Show(Ball, <1, 2, 3>)
Show(Ball, x)
#macro Floor() plane { y, 0 } #end
#macro Moved(V) sphere { V, 1 } #end
Moved(x sphere { 0, 1 } )
Moved(x, y)
Floor(1)
Floor(

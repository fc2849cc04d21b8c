#declare Fractal = julia_fractal { <0, 0, 0, 0> }
sphere { 0, 1 }
object { Fractal }

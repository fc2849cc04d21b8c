julia_fractal { <0, 0, 0, 0> }

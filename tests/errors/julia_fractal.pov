#version 3.7;
julia_fractal { <1, 0, 0, 0> quaternion exp }
julia_fractal { <1, 0, 0, 0> max_iteration 2000000 }
julia_fractal { <1, 0, 0, 0> slice <1, 0, 0, 0>, 1 }
julia_fractal { <1, 0, 0, 0> hypercomplex pwr 2 }
julia_fractal { <1, 0, 0, 0> precision 0 }
julia_fractal { <1, 0, 0, 0> sqare }

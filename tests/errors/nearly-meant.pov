isosurface { function { x*x + y*y + z*z - 1 } container { box { -1, 1 } } }
#macro VNormalize5D(V) V #end
sphere { VNormalize(<1, 2, 3>), 1 }
sphere { 0, 1 pigment { <1, 0, 0> } }
sphere { 0, 1 hollow media { emission 1 } }
camera { location -5*z look_at 0 focal_blur 1 }
camera { location -5*z look_at 0 aperture 0.4 samples 20 }
#declare P = <1, 2, 3>;
sphere { P.X, 1 }
julia_fractal { <0, 1, 0, 0> quaternion sqrt }
sphere { 0, 1 rotate y*clok*360 }

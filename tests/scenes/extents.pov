#version 3.7;
global_settings { assumed_gamma 1 }
// min_extent and max_extent of what is clipped, bounded or without end.
#macro Show (T)
  #debug concat(vstr(3, min_extent(T), ",", 0, 2), " ", vstr(3, max_extent(T), ",", 0, 2), "\n")
#end
#declare A = sphere { 0, 1 clipped_by { plane { -x, 0 } } } Show(A)
#declare A = sphere { 0, 1 clipped_by { box { -.5, .5 } } } Show(A)
#declare A = intersection { sphere { 0, 1 } plane { y, .2 clipped_by { sphere { 0, 1 } } } } Show(A)
#declare A = plane { y, .2 } Show(A)
#declare A = plane { y, .2 bounded_by { sphere { 0, 1 } } } Show(A)
#declare A = intersection { plane { x, 1 } plane { -x, 1 } plane { y, 1 } plane { -y, 1 } plane { z, 1 } } Show(A)
#declare A = intersection { object { A } plane { z, 1 inverse } } Show(A)
#declare A = intersection { union { plane { x, 1 } plane { x, .5 } } sphere { 0, 3 } } Show(A)
#declare A = intersection { plane { x, 1 rotate 90*z } sphere { 0, 3 } } Show(A)
#declare A = difference { sphere { 0, 3 } plane { x, 1 } } Show(A)
#declare A = union { sphere { 0, 2 } plane { y, 0 } } Show(A)
#declare A = sor { 4, <.3, 0>, <.4, .2>, <.6, .6>, <.3, 1> } Show(A)
#declare A = sor { 5, <.3, 0>, <.4, .2>, <.8, .5>, <.3, 1>, <.2, 1.1> } Show(A)
// Cylinders, cones and sweeps: the box of a box that stands along the axis, and
// that of the balls that are named.
#declare A = cylinder { 0, <1, 2, 1>, .5 rotate 30*z } Show(A)
#declare A = cone { <1, 0, 2>, .2, <1, 2, -1>, .5 rotate 40*x } Show(A)
#declare A = cone { 0, .6, <1, 2, 1>, .5 scale 2 } Show(A)
#declare A = union { cylinder { <1, 1, 1>, <0, -2, -3>, .5 open } box { 0, 1 } scale <1, 2, 1> } Show(A)
#declare A = sphere_sweep { cubic_spline 5, <0, 0, 0>, .2, <1, 0, 0>, .3, <1, 1, 0>, .2, <2, 1, 1>, .3, <3, 1, 0>, .2 rotate 30*z } Show(A)
#declare A = sphere_sweep { b_spline 4, <0, 0, 0>, .2, <1, 0, 0>, .3, <1, 1, 0>, .2, <2, 1, 1>, .3 scale <1, 2, 1> } Show(A)
// Lathes of Bezier curves: the box of their control points.
#declare A = lathe { bezier_spline 4, <.5, 0>, <2, -1>, <1.5, 2.5>, <.6, 1.5> } Show(A)
#declare A = lathe { quadratic_spline 5, <.9, -.5>, <.7, 0>, <.3, .7>, <.35, .7>, <.8, 1.5> scale 2 } Show(A)
// Bounds and clips count where the box around what they share is smaller.
#declare A = sphere { 0, 2 bounded_by { box { <-1, -1, -1>, <1, 5, 1> } } } Show(A)
#declare A = union { sphere { 0, 2 } bounded_by { box { <-5, -5, -5>, <1, 5, 5> } } } Show(A)
#declare A = sphere { 0, 2 clipped_by { box { <-5, -5, -5>, <1, 5, 5> } } bounded_by { box { <-1, -1, -1>, <2, 4, 2> } } } Show(A)
#declare A = torus { 2, .5 bounded_by { sphere { 0, 1 } } } Show(A)
#declare A = mesh { triangle { 0, x, y } triangle { x, y, z } bounded_by { box { <.1, -1, .1>, <.6, 1, .6> } } } Show(A)
#declare A = mesh { triangle { 0, x, y } bounded_by { box { .1, .6 } } } Show(A)
// Julia fractals: the radius beyond which nothing comes back.
#declare A = julia_fractal { <-.5, .3, .2, .1> rotate 45*y } Show(A)
#declare A = julia_fractal { <-.5, .3, .2, .1> hypercomplex } Show(A)
// A ball that is turned stays one, until a step that it is none after; corners
// are moved one by one.
#declare A = sphere { x, .4 scale 2 rotate 45*z } Show(A)
#declare A = object { sphere { 0, 1 } rotate <20, 30, 40> } Show(A)
#declare A = sphere { x, .4 rotate 45*z scale <1, 2, 1> } Show(A)
#declare A = sphere { x, .4 scale <1, 2, 1> rotate 45*z } Show(A)
#declare A = sphere { 0, 1 transform { rotate <20, 30, 40> } } Show(A)
#declare A = sphere { y, 1 rotate 20*z pigment { rgb 1 } rotate 45*z scale 2 pigment { rgb 1 } scale <1, 2, 1> } Show(A)
#declare A = object { object { sphere { y, 1 rotate 20*z } scale <1, 2, 3> } rotate 45*z translate x } Show(A)
#declare A = object { sphere { y, 1 rotate 20*z scale <1, 2, 3> } scale <1, .5, 1/3> rotate 45*z } Show(A)
#declare A = sphere { x, 1 scale <-1, 1, 1> rotate 45*z } Show(A)
#declare A = union { sphere { x, 1 } rotate 45*z } Show(A)
#declare A = triangle { 0, x, y rotate 30*z scale <1, 2, 1> rotate 45*z } Show(A)
#declare A = smooth_triangle { x, x, y, y, z, z rotate <20, 30, 40> } Show(A)
#declare A = mesh { triangle { 0, x, y } rotate 30*z } Show(A)
#declare A = polygon { 4, <0, 0>, <1, 0>, <1, 1>, <0, 0> rotate <20, 30, 40> } Show(A)
#declare A = polygon { 4, <0, 0>, <1, 0>, <1, 1>, <0, 0> rotate 90*y } Show(A)
// Inside out, objects are where they were, but not as parts of others.
#declare A = object { sphere { 0, 1 } inverse } Show(A)
#declare A = union { sphere { 0, 1 } box { 0, 2 } inverse } Show(A)
#declare A = union { sphere { 0, 1 inverse } box { 0, 2 } } Show(A)
#declare A = intersection { sphere { 0, 1 inverse } box { 0, 2 } } Show(A)
#declare A = intersection { union { sphere { 0, 1 } box { 0, 1 } inverse } box { -3, 2 } } Show(A)
#declare A = sphere { 0, 5 clipped_by { box { 0, 1 inverse } } } Show(A)
// The last letter begins left of its place: POV-Ray's box is longer by as much.
#declare A = text { ttf "timrom.ttf" "aj" .5, 0 } Show(A)
#declare A = text { ttf "timrom.ttf" "ja" .5, 0 } Show(A)
#declare A = text { ttf "timrom.ttf" "j" .5, 0 scale <2, 1, 1> rotate 90*z } Show(A)

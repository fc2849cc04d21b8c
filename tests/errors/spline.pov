#version 3.7;
#declare A = spline { linear_spline }
#declare B = spline { 0, <0, 1, 2>, 1, "x" }
#declare C = spline { 0, x, 1, y }
#declare D = C(0.5, wavy);
#declare E = C + 1;
#declare F = function(a) { spline { C } }
#declare G = function { internal(99) }
#declare H = C.x;

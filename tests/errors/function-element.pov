// Elements of arrays that are no functions.
#declare A = array[3];
#declare A[0] = function(x) { x };
#declare F = function { A[0](x) + A[1](x) };
sphere { 0, A[0](1, 2) }

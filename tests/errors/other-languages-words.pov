// Words and statements of other languages, also reserved ones.
#declare A = [1, 2, 3];
#declare I = 0;
#declare I++;
#declare I += 2*I;
#declare B = array[2] {1, 2};
#declare N = size(B);
#declare F = function(x) { return x*x; }
light_source { position <0, 5, -5> rgb 1 }
light_source { y rgb 1 spotlight target 0 }
light_source { y rgb 1 shadows off }
fog { distance 10 type 2 }

#declare A = array[2] { 1, 2 };
#macro M()
    sphere
    0, 1
#end
#ifdef (A[M()])
    sphere { 0, 1 }
#else
 box { 0, 1 }
#end

#macro M(A)
    A sphere { 0, A }
#end
#switch (1)
#case (M(2))
    sphere { 0, 1 }
#break
#else
#end

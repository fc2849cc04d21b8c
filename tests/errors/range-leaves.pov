#macro M(A)
    sphere { 0, A }
#end
#switch (1)
#range (M(2), 3)
    sphere { 0, 1 }
#break
#end

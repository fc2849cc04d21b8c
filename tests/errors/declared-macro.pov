#macro Str(A) A #end
#declare Str = "";
#debug Str
#declare N = 0;
#while (N < 3)
    #declare N += 1;
#end
#declare Turn = tau;
plane { Y, 1 }

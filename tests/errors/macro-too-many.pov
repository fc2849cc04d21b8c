#macro M(A) A #end
#declare C = M(1, 2);

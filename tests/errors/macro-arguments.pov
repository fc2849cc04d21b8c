#macro M(A, B) A + B #end
#declare C = M(1);

#macro M(A) M(A+1) #end
M(1)

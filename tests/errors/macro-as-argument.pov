#macro Twice(N) 2*N #end
#macro Apply(What, N) What(N) #end
sphere { 0, Apply(Twice, 1) }

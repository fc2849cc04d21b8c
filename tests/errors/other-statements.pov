#range 0, 1
#case (1)
#switch (1) #range 0, 1 #end
#switch (1) #case 1 sphere { 0, 1 } #end
#declare R : 3;
#declare f(x) = x*x;
#declare sphere = 3;
#declare Foo = macro(a) { sphere { 0, a } }
#macro Bar(A = 1) #end
#macro Twice(A) #return A*2; #end
#declare W = Twice(1);
#if (R = 1 and R = 2) #end
#if (exists("a.inc")) #end
M(1)

// Directives: branches, loops, macros, scopes, skipped garbage.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "check.inc"
#if (0) } ) garbage $ @ ~ #if (1) nested #end ] #else #declare A = 1; #end
Check("else", A, 1)
#if (0) #declare B = 1; #elseif (1) #declare B = 2; #else #declare B = 3; #end
Check("elseif", B, 2)
#ifdef (Nothing) #error "ifdef" #end
#ifndef (A) #error "ifndef" #end
#macro Never() }}} garbage #end
#declare N = 0; #declare I = 0;
#while (I < 10) #declare I = I + 1; #if (I = 5) #break #end #declare N = N + I; #end
Check("while and break", N, 10)
#declare N = 0;
#for (J, 0, 1, 0.1) #declare N = N + 1; #end
Check("for reaches its end", N, 11)
#declare N = 0;
#for (J, 5, 1, -2) #declare N = N*10 + J; #end
Check("for downwards", N, 531)
#declare N = 0;
#for (J, 1, 0) #declare N = 1; #end
Check("for not entered", N, 0)
#macro Which(V)
  #switch (V)
    #case (1) #declare W = W + 10; #break
    #case (2) #case (3) #declare W = W + 20; #break
    #range (4, 6) #declare W = W + 30; #break
    #else #declare W = W + 40;
  #end
#end
#declare W = 0; Which(1)
Check("case", W, 10)
#declare W = 0; Which(2) Which(3)
Check("case falls through", W, 40)
#declare W = 0; Which(4) Which(5.5) Which(6)
Check("range", W, 90)
#declare W = 0; Which(7)
Check("switch else", W, 40)
#macro Text(A) A+2 #end
Check("macros are text", 2*Text(1), 4)
#macro Square(A) A*A #end
Check("arguments are values", Square(1+1), 4)
#macro Set(Ref, Value) #declare Ref = Value; #end
#declare Target = 1; Set(Target, 7)
Check("by reference", Target, 7)
#macro SetLocal(Ref) #local Ref = 9; #end
SetLocal(Target)
Check("#local of a parameter is its argument", Target, 9)
#macro SetOwn() #local Q = 1; #declare Q = 2; Q #end
Check("#declare of a local", SetOwn(), 2)
#ifdef (Q) #error "#declare of a local made a global" #end
#macro Locals() #local L = 5; #declare G = L; L #end
Check("local value", Locals(), 5)
#ifdef (L) #error "a #local leaked" #end
Check("global from a macro", G, 5)
#macro Open() sphere { 0, 1 #end
#macro Close() } #end
Open() pigment { rgb 1 } Close()
#macro Factorial(K) #if (K < 2) #local F = 1; #else #local F = K*Factorial(K-1); #end F #end
Check("recursion", Factorial(5), 120)
#macro Sum(A, B) (A + B) #end
Check("macro in an argument", Sum(Sum(1,2), Sum(3,4)), 10)
#macro Empty() #end
Empty()
union { #for (K, 1, 3) sphere { K*x, .5 } #end pigment { rgb 1 } }
#declare Table = array[4];
#for (K, 0, 3) #declare Table[K] = K*K; #end
Check("elements set", Table[3], 9)
#declare Mixed = array[2][2];
#declare Mixed[1][0] = "text";
CheckText("string element", Mixed[1][0], "text")
#undef A
#ifdef (A) #error "undef" #end
#declare deprecated once "use B" Old = 3;
#declare D = #if (1) 5; #else 6; #end
Check("a directive in a value", D, 5)
#local Here = 3;
Check("local of the file", Here, 3)
#declare Shape = sphere { 0, 1 }
#declare Other = Shape
object { Other pigment { rgb 1 } }
#macro Deep(Level) #declare Depth = Depth + 1; #if (Level > 0) Deep(Level - 1) #end #end
#declare Depth = 0; Deep(50)
Check("deep recursion", Depth, 51)
#ifdef (Glim) #declare Seen = Glim; #else #declare Seen = 1; #end
#if (Seen <= 0) #error "Glim" #end
#if (version < 3) #version 99; #end
#include concat("empty", ".inc")

// What POV-Ray 3.7 reads, and some with a warning; the values are its own.
#version 3.7;
global_settings { assumed_gamma 1 subsurface { samples 10, 10 radiosity on } }
#macro Say(Text, Number) #debug concat(Text, " ", str(Number, 0, 0), "\n") #end

// Arrays of arrays.
#declare A = array[2] { array[2] { 0, 1 }, array[3] { 1, 0, 2 } };
#declare E = A[1];
#declare E[0] = 9;
Say("copied", E[2] + dimension_size(E, 1))
Say("its own", A[1][0])
#macro Second(B) Say("argument", B[1]) #end
Second(A[0])
Say("size", dimension_size(A[1], 1))

// Elements are passed by reference.
#macro Set(X, V) #declare X = V; #end
#macro Twice(X) Set(X, X + 1) Set(X, X + 1) #end
#declare P = array[2][2] { { 1, 2 }, { 3, 4 } };
Set(P[0][1], 9)
Say("set", P[0][1])
Twice(P[1][1])
Say("twice", P[1][1])
#macro Both(X) #declare P[0][0] = 7; Say("seen", X) #end
Both(P[0][0])
#macro Inner(X) #declare X[0] = 5; #end
Inner(A[1])
Say("inner", A[1][0])

// Semicolons.
#declare F = 1;;
#macro M() 2; #end
#declare F = M();
#macro N() #declare F = 3; #end
N();
Say("number", F)

// Days since 2000; the time itself changes.
#debug concat(datetime(7000.25, "%Y %j %H"), "\n")
#debug concat(datetime(-1), "\n")
#if (now < 9800) #error "the clock is behind" #end

// Passed over, or told.
#sphere { 0, 1 }
declare G = 4;
Say("without", G)
#render "rendered\n"
#statistics "counted\n"
prism { linear_spline 0, 1, 3, <-1, 0>, <0, 1>, <1, 0> }
sphere { 0, 1 finish { ior 1.3 caustics 1 } }
#version 3.5;
global_settings { radiosity { count 20 load_file "nope.rad" } }
#version 3.8;

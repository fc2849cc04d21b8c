// Prints what patterns and functions say at random points: POV-Ray and glim
// must print the same numbers. See run.
#version 3.7;
#include "functions.inc"

#macro Show (Name, Field)
  #local Stream = seed(11);
  #for (I, 1, 40)
    #local X = 20*rand(Stream) - 10;
    #local Y = 20*rand(Stream) - 10;
    #local Z = 20*rand(Stream) - 10;
    #debug concat("value ", Name, " ", str(Field(X, Y, Z), 0, 9), "\n")
  #end
#end

ROWS

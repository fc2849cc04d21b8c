#version 3.7;
#ifdef (Glim) #debug "glim" #else #warning "other" #end
#ifndef (N) #declare N = 3; #end
#local M = 2;
#macro Row(Count, Gap)
    #local I = 0;
    #while (I < Count)
        sphere { I*x, 0.5 }
        #local I = I + 1;
        #if (I = 7) #break #elseif (I = 8) #undef I #else #end
    #end
#end
#for (J, 0, 2, 0.5) Row(N, J) #if (J > 1) #break #end #end
#switch (N) #case (1) #case (2) #range (3, 5) box { 0, 1 } #break
    #default #error "none" #end
#include "part.inc"
object { Part }
#declare deprecated once "old" Old = 1;
#declare G = function { x + y };
#undef G
union { Row(2, 1) #default { pigment { rgb 1 } } }
#fopen Out "x.txt" write
#write (Out, 1)
#fclose Out
#read (Out, Q)

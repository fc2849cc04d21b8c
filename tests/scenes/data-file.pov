// Reading data, and reading back what was written.
#version 3.7;
#macro Say(S) #debug concat(S, "\n") #end
#fopen In "data-file.txt" read
#declare Name = array[2] { "none", "none" };
#declare Place = 0;
#while (defined(In))
    #read (In, Number, Place, Name[1])
    Say(concat(str(Number, 0, 1), " at ", vstr(3, Place, ",", 0, 1), ": ", Name[1]))
#end
#fclose In
#fopen Out "data-file.tmp" write
#write (Out, "#declare Third = ", 1/3, "; ", "#declare Three = ", 3*x + 2*z, ";\n")
#fclose Out
#fopen Out "data-file.tmp" append
#write (Out, "#declare Million = ", 1000000 ";")
#fclose Out
#include "data-file.tmp"
Say(concat(str(Third, 0, 6), " ", vstr(3, Three, ",", 0, 1), " ", str(Million, 0, 0)))
// A macro that is written and included again and again.
#macro Value(S)
    #fopen Out "value.tmp" write
    #write (Out, S)
    #fclose Out
    #include "value.tmp"
#end
#declare A = Value("1 + 2");
#declare B = Value("A * 2");
Say(str(B, 0, 0))
// The file on disk goes before what is appended, and stays as it is.
#fopen Out "data-file.txt" append
#write (Out, ",7")
#fclose Out
#fopen In "data-file.txt" read
#read (In, N, N, N, N, N, N, N, N, N)
#ifdef (In) #error "values are left" #end
Say(str(N, 0, 0))
// The handle is global, what is read into a local variable is local.
#macro Inside()
    #fopen In "data-file.txt" read
    #local L = 0;
    #read (In, L)
#end
Inside()
#ifdef (L) #error "it is local" #end
#fclose In
#fopen Raw "data-file.df3" write
#write (Raw, uint16be <3, 4, 5>)
sphere { 0, 1 }

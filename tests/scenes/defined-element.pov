// An element of an array that was never set is not defined.
#version 3.7;
#declare A = array[2][2];
#declare A[0][1] = "x";
#ifdef (A[0][1]) #else #error "A[0][1] is set" #end
#ifdef (A[1][0]) #error "A[1][0] is not set" #end
#ifndef (A[1][1]) #else #error "A[1][1] is not set" #end
#if (defined(A[0][1]) & !defined(A[0][0]) & defined(A) & !defined(B)) #else
    #error "defined() takes elements"
#end
global_settings { assumed_gamma 1 }
sphere { 0, 1 }

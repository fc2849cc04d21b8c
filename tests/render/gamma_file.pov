// Gamma: File_Gamma decides the numbers in the file.
// compare: exact
// options: File_Gamma=1.8
#version 3.7;
global_settings { assumed_gamma 1 }
#include "parts/gamma.inc"

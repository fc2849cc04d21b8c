// Gamma: no assumed_gamma after #version 3.7 is assumed_gamma 1.
// compare: exact
#version 3.7;
#include "parts/gamma.inc"

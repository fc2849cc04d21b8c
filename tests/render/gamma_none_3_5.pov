// Gamma: no assumed_gamma with #version 3.5: no correction at all.
// compare: exact
#version 3.5;
#include "parts/gamma.inc"

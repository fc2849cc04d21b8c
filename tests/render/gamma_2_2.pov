// Gamma: assumed_gamma 2.2, arithmetic in a power space.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 2.2 }
#include "parts/gamma.inc"

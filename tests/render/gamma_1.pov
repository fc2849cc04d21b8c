// Gamma: assumed_gamma 1, arithmetic in linear light.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1.0 }
#include "parts/gamma.inc"

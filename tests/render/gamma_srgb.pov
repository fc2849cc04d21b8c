// Gamma: assumed_gamma srgb, and srgb colours.
// compare: exact
#version 3.7;
global_settings { assumed_gamma srgb }
#include "parts/gamma.inc"

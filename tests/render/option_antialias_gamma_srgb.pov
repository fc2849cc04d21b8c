// +A's threshold is of light, also where numbers are kept as sRGB.
// compare: exact
// options: +A0.3 -J
#version 3.7;
global_settings { assumed_gamma srgb }
#include "parts/grains.inc"

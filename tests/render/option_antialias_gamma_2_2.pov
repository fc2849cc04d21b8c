// +A's threshold is of light, also where numbers are kept in a power space.
// compare: exact
// options: +A0.3 -J
#version 3.7;
global_settings { assumed_gamma 2.2 }
#include "parts/grains.inc"

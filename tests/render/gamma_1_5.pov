// Gamma: an unusual assumed_gamma, and only the first one counts.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1.5 }
global_settings { assumed_gamma 1 }
#include "parts/gamma.inc"

// Gamma: assumed_gamma without #version.
// compare: exact
global_settings { assumed_gamma 1 }
#include "parts/gamma.inc"

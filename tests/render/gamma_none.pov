// Gamma: neither #version nor assumed_gamma: no correction at all.
// compare: exact
// (the scene begins at once)
#include "parts/gamma.inc"

// +A with method 1: one pass, a grid of samples where neighbours differ.
// compare: exact
// options: +A0.1 +AM1 +R3 -J
#include "parts/still_life.inc"

// +Q1: what is left out at this quality.
// compare: exact
// options: +Q1
#include "parts/still_life.inc"

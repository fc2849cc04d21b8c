// +Q2: what is left out at this quality.
// compare: exact
// options: +Q2
#include "parts/still_life.inc"

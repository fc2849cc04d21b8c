// +Q5: what is left out at this quality.
// compare: exact
// options: +Q5
#include "parts/still_life.inc"

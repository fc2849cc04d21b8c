// +Q8: what is left out at this quality.
// compare: exact
// options: +Q8
#include "parts/still_life.inc"

// +Q4: what is left out at this quality.
// compare: exact
// options: +Q4
#include "parts/still_life.inc"

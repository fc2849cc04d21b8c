// +Q7: what is left out at this quality.
// compare: exact
// options: +Q7
#include "parts/still_life.inc"

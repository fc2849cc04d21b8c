// +Q6: what is left out at this quality.
// compare: exact
// options: +Q6
#include "parts/still_life.inc"

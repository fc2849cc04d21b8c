// +Q0: what is left out at this quality.
// compare: exact
// options: +Q0
#include "parts/still_life.inc"

// +Q3: what is left out at this quality.
// compare: exact
// options: +Q3
#include "parts/still_life.inc"

// +A's threshold is measured after +AG; the default threshold.
// compare: exact
// options: +A +AM1 +R2 +AG1.0 -J
#include "parts/still_life.inc"

// +A with method 2: recursive, from the corners of pixels.
// compare: exact
// options: +A0.1 +AM2 +R2 -J
#include "parts/still_life.inc"

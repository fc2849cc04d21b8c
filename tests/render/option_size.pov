// A picture of another shape does not change what the camera sees.
// compare: exact
// options: +W90 +H120
#include "parts/still_life.inc"

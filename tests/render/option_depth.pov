// 16 bits a channel.
// compare: exact
// options: +FN16
#include "parts/still_life.inc"

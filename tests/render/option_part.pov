// +SR +ER +SC +EC: a part of the picture, the rest black.
// compare: exact
// options: +SR21 +ER90 +SC0.25 +EC140
#include "parts/still_life.inc"

#include "colors.inc
#include "golds.inc"
sphere { 0, 1 pigment { Red } }

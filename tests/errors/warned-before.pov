include "colors.inc"
declare R = 1;
sphere { 0, R rgb x }
sphere { 0, 1 pigment { rgb <255, 128, 0> } }
#sphere { 0, 1 }
wrong

#include "nothing-here.inc"

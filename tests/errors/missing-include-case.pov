#include "Colors.inc"

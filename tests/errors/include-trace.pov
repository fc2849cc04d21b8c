#include "include-trace.inc"

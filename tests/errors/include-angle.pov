#include <colors.inc>
sphere { 0, 1 pigment { Red } }

#include “colors.inc”
sphere { 0, 1 pigment { Red } translate –x*2×3 }
sphere { 0, 1 pigment { image_map { png ‘a.png’ } } }
sphere { 0, 1 }

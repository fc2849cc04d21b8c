// A ball that rolls by in the open, seen from a camera that flies past.
#declare Open = 1;
#declare Place = <-0.2 + clock, 1.5 + 0.5 * clock, -3.6 + clock>;
#declare Look = <0.3, 1.4, 4>;
#declare Moves = sphere { <2.3 - 2.5 * clock, 0.4, -1.5 + clock>, 0.4
  pigment { rgb <0.9, 0.8, 0.2> } }
#include "flicker.inc"

// A ball that moves in the shade of a room that is lit through a window.
#declare Place = <-0.2, 1.5, -3.6>;
#declare Look = <0.3, 1.4, 4>;
#declare Moves = sphere { <2.3 - 2.5 * clock, 0.4, -1.5 + clock>, 0.4
  pigment { rgb <0.9, 0.8, 0.2> } }
#include "flicker.inc"

// A box that turns while it moves in a room that is lit through a window.
#declare Place = <-0.2, 1.5, -3.6>;
#declare Look = <0.3, 1.4, 4>;
#declare Moves = box { -0.4, 0.4 rotate y * 90 * clock
  translate <2.3 - 2.2 * clock, 0.7, -1.5 + clock>
  pigment { rgb <0.3, 0.8, 0.9> } }
#include "flicker.inc"

// A ball that rolls so slowly through the sun in a room that is lit through a
// window that light itself hardly flickers.
#declare Place = <-0.2, 1.5, -3.6>;
#declare Look = <0.3, 1.4, 4>;
#declare Moves = sphere { <-1 + 0.8 * clock, 0.5, 2.9 - 0.65 * clock>, 0.5
  pigment { rgb <0.9, 0.8, 0.2> } }
#include "flicker.inc"

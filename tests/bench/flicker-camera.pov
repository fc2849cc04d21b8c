// A camera that moves into a room that is lit through a window.
#declare Place = <0.2 - 0.5 * clock, 1.5, -9 + 7.5 * clock>;
#declare Look = <0.3 * clock, 1.4, 4>;
#declare Moves = sphere { <0.8, 0.4, 0>, 0.4 pigment { rgb <0.9, 0.8, 0.2> } }
#include "flicker.inc"

// screen.inc says its camera more than once, and that is no news.
#version 3.7;
#include "screen.inc"
global_settings { assumed_gamma 1 }
Set_Camera(<3, 4, -9>, <0, .8, 0>, 45)

#version 3.7;
global_settings { assumed_gamma 1 }
#include "colors.inc"
camera { location <0,2,-5> look_at 0 }
light_source { <5,5,-5> White }
#declare S = "hello;
sphere { 0, 1 pigment { Red } }
text { ttf "timrom.ttf" S 0.2, 0 pigment { Blue } }

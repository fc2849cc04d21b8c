// Expressions: precedence, promotion, comparison, dot access, colours.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "check.inc"
Check("precedence", 2+3*4-6/3, 12)
Check("unary minus", -2*-3, 6)
Check("left to right", 100/10/5, 2)
Check("parentheses", (2+3)*4, 20)
Check("comparison", (2 > 1) + (1 >= 1) + (1 < 2) + (2 <= 2) + (1 = 1) + (1 != 2), 6)
Check("logic", (1 & 0) + (1 | 0) + !0 + !5, 2)
Check("ternary", (1 > 2 ? 10 : 20), 20)
Check("nested ternary", (0 ? 1 : (1 ? 2 : 3)), 2)
CheckVector("vector times float", <1,2,3>*2, <2,4,6>)
CheckVector("vector times vector", <1,2,3>*<2,3,4>, <2,6,12>)
CheckVector("float promoted", <1,2,3>+1, <2,3,4>)
CheckVector("axes", x+2*y-z, <1,2,-1>)
CheckVector("float minus vector", 1-<1,2,3>, <0,-1,-2>)
Check("dot x", (<4,5,6>).x, 4)
Check("dot z of a sum", (x+2*z).z, 2)
Check("dot on a call", vnormalize(<0,3,4>).y, 0.6)
#declare V4 = <1,2,3,4>;
Check("t", V4.t, 4)
#declare C = rgbft <.25,.5,.75,.125,.5>;
Check("red", C.red, .25)
Check("filter", C.filter, .125)
Check("transmit", C.transmit, .5)
#declare White = rgb 1;
Check("gray", White.gray, 1)
#declare Red = rgb x;
#declare Blue = rgb z;
#declare Mix = Red*0.5 + Blue;
Check("colour sum red", Mix.red, .5)
Check("colour sum blue", Mix.blue, 1)
#declare Old = color red 1 green .5 filter .25;
Check("old colour", Old.green + Old.filter, .75)
#declare All = color 1;
Check("color 1 fills all five", All.transmit, 1)
#declare Three = rgb 1;
Check("rgb 1 fills three", Three.transmit, 0)
#declare S = srgb .5;
Check("srgb", (abs(S.red - pow((.5+.055)/1.055, 2.4)) < 1e-6), 1)
#declare S2 = srgb .25*2;
Check("srgb decodes last", S2.red, S.red)
#declare U = <1,2>;
Check("u and v", U.u*10 + U.v, 12)
Check("booleans", true + yes + on + false + no + off, 3)
Check("clock", clock, 0)
Check("version", version, 3.7)

// Float, vector and string functions.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "check.inc"
Check("abs", abs(-2.5), 2.5)
Check("acos", acos(0), pi/2)
Check("asin", asin(1), pi/2)
Check("atan2", atan2(1,-1), 3*pi/4)
Check("acosh", acosh(2), ln(2+sqrt(3)))
Check("asinh", asinh(1), ln(1+sqrt(2)))
Check("atanh", atanh(.5), ln(3)/2)
Check("sinh", sinh(1), (exp(1)-exp(-1))/2)
Check("cosh", cosh(1), (exp(1)+exp(-1))/2)
Check("tanh", tanh(1), sinh(1)/cosh(1))
Check("ceil", ceil(-1.5)*10 + ceil(1.2), -8)
Check("floor", floor(-1.5)*10 + floor(1.8), -19)
Check("int", int(-1.7)*10 + int(1.7), -9)
Check("div", div(7,2), 3)
Check("mod", mod(-7,3), -1)
Check("pow", pow(2,10), 1024)
Check("sqrt", sqrt(2)*sqrt(2), 2)
Check("ln", ln(exp(2)), 2)
Check("log is base 10", log(1000), 3)
Check("degrees", degrees(pi), 180)
Check("radians", radians(180), pi)
Check("min", min(3,1,2), 1)
Check("max", max(3,1,2), 3)
Check("select", select(-1,10,20,30) + select(0,10,20,30) + select(1,10,20,30), 60)
Check("select of three", select(-1,1,2), 1)
Check("tan", tan(pi/4), 1)
Check("sin", sin(pi/6), .5)
Check("cos", cos(pi/3), .5)
Check("vdot", vdot(<1,2,3>,<4,5,6>), 32)
Check("vlength", vlength(<3,4,12>), 13)
CheckVector("vcross", vcross(x,y), z)
CheckVector("vnormalize", vnormalize(<0,0,5>), z)
CheckVector("vrotate z", vrotate(x, z*90), y)
CheckVector("vrotate y", vrotate(x, y*90), -z)
CheckVector("vrotate x", vrotate(y, x*90), z)
CheckVector("vrotate order", vrotate(x, <10,20,30>),
  vrotate(vrotate(vrotate(x, 10*x), 20*y), 30*z))
CheckVector("vaxis_rotate", vaxis_rotate(x, y, 90), -z)
CheckVector("vaxis_rotate diagonal", vaxis_rotate(x, <1,1,1>, 120), y)
Check("strlen", strlen("hello"), 5)
Check("strcmp", (strcmp("a","b") < 0) + (strcmp("b","a") > 0) + (strcmp("a","a") = 0), 3)
Check("asc", asc("A"), 65)
Check("val", val("-12.5e1"), -125)
CheckText("chr", chr(65), "A")
CheckText("concat", concat("a","b","c"), "abc")
CheckText("substr", substr("abcdef",2,3), "bcd")
CheckText("strupr", strupr("aBc1"), "ABC1")
CheckText("strlwr", strlwr("AbC1"), "abc1")
CheckText("str", str(3.14159,0,3), "3.142")
CheckText("str padded", str(2,5,1), "  2.0")
CheckText("str zeros", str(2,-5,1), "002.0")
CheckText("str rounds", str(3.7,0,0), "4")
CheckText("vstr", vstr(3,<1,2,3>,", ",0,1), "1.0, 2.0, 3.0")
#declare R = seed(42);
Check("rand 1", rand(R), mod(42*1812433253+12345, 4294967296)/4294967296)
#declare State = mod(42*1812433253+12345, 4294967296);
#declare High = floor(State/65536);
#declare Low = State - High*65536;
#declare Next = mod(mod(High*1812433253, 65536)*65536 + mod(Low*1812433253, 4294967296) + 12345, 4294967296);
Check("rand 2", rand(R), Next/4294967296)
#declare A = array[3] {1,2,3}
Check("dimension_size", dimension_size(A,1), 3)
#declare B = array[2][3] {{1,2,3},{4,5,6}}
Check("dimensions", dimensions(B), 2)
Check("element", B[1][2], 6)
#declare Box = box { -1, <1,2,3> translate x };
CheckVector("min_extent", min_extent(Box), <0,-1,-1>)
CheckVector("max_extent", max_extent(Box), <2,2,3>)
Check("file_exists", file_exists("check.inc")*2 + file_exists("no-such-file"), 2)
Check("defined", defined(Box)*2 + defined(Nothing), 2)
#declare Words = text { ttf "timrom.ttf" "A. " 1, 0.5*x }
CheckVector("extent of a text", max_extent(Words), <2.014,0.696,1>)
// A pattern of an object, with what moves it inside and outside of its block.
#declare F = function { pattern { object { sphere { 0, 1 translate x } scale 2 } } }
#if (F(2, 0, 0) != 1 | F(-1, 0, 0) != 0) #error "the object's pattern" #end
// The scene's own file.
#if (strcmp(input_file_name, "functions.pov") != 0) #error "input_file_name" #end

// Lexical rules: comments, numbers, escapes, optional commas, reserved words.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "check.inc"
/* a /* nested */ comment */
# declare A = 1; // blanks after '#'
Check("point first", .5, 1/2)
Check("point last", 1., 1)
Check("exponent", 1e-3, 0.001)
Check("exponent sign", 2.5E+2, 250)
Check("many digits", 3.14159265358979323846, pi)
Check("big", 123456789012345678901234567890.0, 1.2345678901234568e29)
Check("subtraction without a comma", vlength(<0 0 -1>) , 1)
#declare V = <1 2 3>;
CheckVector("no commas", V, <1,2,3>)
#declare W = <0 0 -1>;
Check("0 -1 is a subtraction", W.y, -1)
CheckText("escapes", "a\tb\\c\"d", concat("a", chr(9), "b", chr(92), "c", chr(34), "d"))
CheckText("unicode", "\u0041", "A")
#declare under_score_1 = 4;
Check("names", under_score_1, 4)
#declare Case = 1; #declare CASE = 2;
Check("case matters", Case*10 + CASE, 12)
sphere{0,1 pigment{rgb 1}finish{ambient.5diffuse 0 specular.5roughness.01}}
sphere { 0 1 pigment { color rgb<1,0,0> } }
sphere { <0,0,0>, 1 pigment { color red 1 green .5 } }
camera { location -3*z look_at 0 }

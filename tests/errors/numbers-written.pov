/* Numbers as other languages write them; between them what is right. */
sphere { 0, 1 pigment { rgb 0xff8000 } }
#declare A = 0x1F;
#declare B = 1.5f;
sphere { <0.0f, 1.0f, 0.0f>, 1 }
#declare C = 1_000_000;
#declare D = 2(A + 1);
#declare E = 2x;
#declare F = 1,5;
#declare V = 1, -2, 3;
#declare W = V[0];
#declare W = x;
#declare G = W[0];
#declare H = 7 // 2;
#declare I = (1 + 2));
sphere { 0, 1 pigment { color "#ff0000" } }
sphere { 0, 1 pigment { color #fff } }
box { 0, 1 translate 30deg*x }
#declare J = 50px;

for (I, 0, 3)
  sphere { I*x, 1 }
end
R = 1;
float S = 2;
sphere { 0, R + S }
#declar T = 1;
#set U = 1;
#define V 1
sphere { T, U + V }
#import "colors.inc"
sphere { 0, 1 pigment { Red } }
while (R < 3)
  R = R + 1;
end
#if (0) #else if (R > 2) sphere { 0, 1 } #end
macro Ball(Size) sphere { 0, Size } end
Ball(2)
#print "x"
function f(x) { x*2 }
texture { pigment { rgb 1 } }
camera { fov 60 }
sphere { 0, 1 finish { shininess 3 } }
cube { 0, 1 }
#declare my-ball = 1;
#declare 2nd = 1;
#for (i = 0; i < 3; i++) #end
#if R = 3 #end

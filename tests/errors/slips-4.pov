#version 3.7;
#declare F = function(z) { sqr(z) }
sphere { 0, 1 interior { media { scattering { rgb 0.5 } } } }
lathe { linear_spline 4, <0,0>,<1,1>,<1,2>,<0,3>,<0,4> pigment { rgb 1 } }
object { sphere { 0, 1 } box { 0, 1 } }
sphere { 0, 1 pigment { Glass } }
#macro M(A) A #end
mesh { texture_list { 1, texture { pigment { rgb 1 } } } triangle { 0, x, y } }
sphere { 0, 1 pigment { hsv <1,2,3> } }
#if (0) sphere { 0, 1 }
#elif (1) sphere { 0, 2 }
#end
sphere { 0, M(1 }

#version 3.7;
// Splines of all kinds, beyond their ends, with few points; POV-Ray prints the
// same.
global_settings { assumed_gamma 1 }
#macro Show (S, Last)
  #for (I, -1, Last, 0.75)
    #debug concat(str(I, 0, 2), " ", vstr(3, S(I), ",", 0, 6), "\n")
  #end
#end
#declare L = spline {
  linear_spline 0,<1,2,3> 1,<2,5,1> 2.5,<0,1,9> 3,<4,4,4> 4,<1,7,2>
}
#declare N = array[2] { spline { L natural_spline }, spline { L } }
Show(L, 5) Show(spline { L quadratic_spline }, 5)
Show(spline { L cubic_spline }, 5) Show(N[0], 5)
#debug concat(vstr(3, N[1](1.3, cubic_spline), ",", 0, 6), "\n")
Show(spline { cubic_spline 3,<1,2,3> 1,<2,5,1> }, 3)
Show(spline { quadratic_spline 3,<1,2,3> 1,<2,5,1> }, 3)
Show(spline { natural_spline 3,<1,2,3> }, 3)
#declare M = spline { 3,<1,2> 1,<2,5,1,4> 2,5 1,<7,7,7>  0,<9,9,9,3,2> }
#debug concat(vstr(5, M(0), ",", 0, 3), " ", vstr(5, M(1), ",", 0, 3), " ",
  str(M(1.5).transmit, 0, 3), "\n")
#declare F = function { spline { L } }
#declare T = function { transform { rotate 30*z translate x scale 2 } }
#declare G = function(x, y) { F(x).y + F(y).z + T(x, y, 1).x }
#declare P = function { pigment { color rgb <0.3, 0.6, 0.2> } }
#declare H = function { P(x, y, z).hf }
#debug concat(vstr(3, F(0.5), ",", 0, 6), " ", vstr(3, T(1, 2, 3), ",", 0, 6),
  " ", str(G(0.5, 2.7), 0, 6), " ", str(H(0, 0, 0), 0, 6), "\n")
#declare S = spline { linear_spline 0,<1,2,3,4> 1,7 2,<4,5> 3,<8,9,1> 4,2 }
#for (I, 0, 4) #debug concat(vstr(5, <0,0,0,0,0> + S(I), ",", 0, 0), " ") #end
#declare S = spline { S 2.5,6 }
#debug concat(vstr(5, <0,0,0,0,0> + S(2.5), ",", 0, 0), "\n")

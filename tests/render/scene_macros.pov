// Recursive macros, splines, arrays, rand.inc and transforms.inc.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
#include "math.inc"
#include "rand.inc"
#include "transforms.inc"
camera { location <3, 6, -10> look_at <0, 1, 0> angle 40 }
light_source { <-6, 12, -8>, rgb 1 }
#declare N = 24;
#declare Cols = array[4] { rgb <1,.2,.1>, rgb <.2,.8,.2>, rgb <.1,.3,1>, rgb <.9,.8,.1> }
#declare Grid = array[3][4] { {1,2,3,4}, {4,3,2,1}, {2,2,5,1} };
#declare S = spline { natural_spline -1, <-4,0,0>, 0, <-3,1,2>, 0.25, <0,3,1>, 0.5, <3,1,0>, 1, <4,0,-2>, 2, <5,0,0> }
#macro Bead(P, C, Rad)
  sphere { P, Rad pigment { C } finish { phong .7 } }
#end
#for (I, 0, N)
  Bead(S(I/N), Cols[mod(I,4)], 0.15)
#end
#for (I, 0, N, 6) Bead(S(I/N, linear_spline), rgb 1, 0.3) #end
#macro Tree(Len, Depth, Trans)
  union {
    cone { 0, Len*0.1, y*Len, Len*0.06 }
    #if (Depth > 0)
      #local K = 0;
      #while (K < 3)
        object { Tree(Len*0.65, Depth-1, 0) rotate z*35 rotate y*(120*K + 20*Depth) translate y*Len }
        #local K = K + 1;
      #end
    #else sphere { y*Len, Len*0.4 pigment { rgb <.2,.6,.2> } } #end
    pigment { rgb <.5,.35,.2> }
  }
#end
object { Tree(1.6, 3, 0) translate z*1.5 }
#declare Y = 0;
#while (Y < dimension_size(Grid, 1)) #declare X = 0;
  #while (X < dimension_size(Grid, 2))
    box { <X*0.5, 0, Y*0.5>, <X*0.5+0.4, Grid[Y][X]*0.2, Y*0.5+0.4> pigment { rgb <X/4, Y/3, 0.5> } translate <1.5,0,-3.5> }
    #declare X = X+1;
  #end #declare Y = Y+1;
#end
#declare Rs = seed(42);
#for (I, 1, 40) sphere { VRand_In_Box(<-4,0,-4>,<-1,0.3,-1>,Rs), 0.1 + 0.05*SRand(Rs) pigment { rgb VRand_On_Sphere(Rs)*0.5+0.5 } } #end
cylinder { 0, y, 0.1 Reorient_Trans(y, <1,1,-1>) translate <-4,0,2> pigment { rgb 1 } }
box { -0.3, 0.3 Axis_Rotate_Trans(<1,1,0>, 40) Shear_Trans(x, y+0.4*x, z) translate <4,1,2> pigment { rgb <1,0,1> } }
plane { y, 0 pigment { rgb 0.8 } }

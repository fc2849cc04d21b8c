// Macros: parameters of every kind, a value as the result, recursion, locals,
// a parameter changed in place, an opening brace from a macro.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
#include "parts/shapes.inc"
camera { location <0, 4, -9> right 4/3*x look_at <0, 1.3, 0> angle 42 }
light_source { <-5, 9, -6>, rgb 1 }
background { rgb <.5, .6, .8> }
#macro Tint(V) rgb (V + <.2, .1, .3>)/1.3 #end
#macro Twice(N) (2*N) #end
#macro Count(N) #declare N = N + 1; #end
#macro Tree(Depth, Length)
    #local Leaf = (Depth = 0);
    #if (Leaf)
        sphere { 0, .22 pigment { Tint(<.2, .8, .2>) } }
    #else
        cylinder { 0, Length*y, .04*Depth pigment { Tint(<.5, .3, .1>) } }
        union { Tree(Depth - 1, .75*Length) rotate 35*z translate Length*y }
        union { Tree(Depth - 1, .7*Length) rotate <30, 0, -30> translate Length*y }
    #end
#end
#macro Start(P) box { P, P + .6 #end
union { Tree(4, 1) translate <-1.6, 0, 0> }
Place(sphere { 0, .5 }, <.8, .5, -1>, texture { pigment { Tint(<.9, .2, .2>) } })
Place(object { Column(1.2, 6) }, <2.2, 0, 0>, texture { pigment { rgb <.9, .8, .5> } })
Start(<.2, 0, -2.4>) pigment { Tint(y) } }
#declare N = 0;
Count(N) Count(N) Count(N)
#local Side = N/Twice(2);
box { 0, Side pigment { rgb <.3, .4, .9> } rotate 20*y translate <-.6, 0, -2.9> }
plane { y, -.01 pigment { rgb .6 } }

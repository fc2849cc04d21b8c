// Things set on an isosurface by trace, and text letter by letter.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
#include "strings.inc"
camera { location <0,4,-8> look_at <0,0,1> angle 45 }
light_source { <-6,8,-6> rgb 1 }
#declare Ground = isosurface { function { y - 0.4*sin(x*1.3)*cos(z*1.1) } contained_by { box { <-4,-1,-4>,<4,1,4> } } max_gradient 1.3 pigment { rgb <.4,.6,.3> } }
object { Ground }
#declare S = seed(11);
#for (I,1,60)
  #local N = <0,0,0>;
  #local P = trace(Ground, <rand(S)*7-3.5, 3, rand(S)*7-3.5>, -y, N);
  #if (vlength(N) > 0)
    cone { P, 0.12, P+N*0.6, 0 pigment { rgb <.5+.5*rand(S), .3, .2> } }
  #end
#end
#macro Chain(S, I) #if (I <= strlen(S)) text { ttf "cyrvetic.ttf" substr(S,I,1) 0.1, 0 scale 0.6 translate <I*0.45-2, 1.5+0.3*sin(I), -2> pigment { rgb <1,.8,.2> } } Chain(S, I+1) #end #end
Chain("isosurface", 1)

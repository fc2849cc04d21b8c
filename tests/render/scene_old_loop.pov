// A scene of version 3.0: no semicolons, colour lists, switch in a loop.
// compare: exact
#version 3.0
#include "colors.inc"
#include "stones.inc"
#declare Count = 0
#declare Step = 30
camera { location <0, 6, -8> look_at <0, 0, 0> }
light_source { <10, 20, -10> color White }
#while (Count < 360)
  object { #switch (mod(Count, 90)) #case (0) box { -0.4, 0.4 } #break #case (30) sphere { 0, 0.5 } #break #else cone { -y*0.4, 0.5, y*0.5, 0 } #end
    texture { T_Stone1 scale 0.5 } translate x*3 rotate y*Count }
  #declare Count = Count + Step
#end
torus { 1.5, 0.3 pigment { color red 0.8 green 0.3 blue 0.1 } finish { reflection 0.2 phong 0.7 } }
sphere { <0, 1, 0>, .8 texture { T_Stone8 } }
plane { y, -0.6 pigment { wood color_map { [0 color Tan] [1 color DarkBrown] } turbulence 0.1 rotate x*90 } }
background { color rgb <0.3 0.4 0.6> }

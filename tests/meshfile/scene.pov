// A corner with a ball, a pane and lamps; what changes is declared.
#version 3.7;
#ifndef (Lamps) #declare Lamps = 2; #end
#ifndef (Lamp) #declare Lamp = 1; #end
#ifndef (Ball) #declare Ball = 0; #end
#ifndef (Wall) #declare Wall = 0.8; #end
#ifndef (Pane) #declare Pane = 0.7; #end
#ifndef (Sky) #declare Sky = 0.1; #end
#ifndef (Move) #declare Move = 0; #end
#ifndef (Eye) #declare Eye = 0; #end
global_settings { assumed_gamma 1 }
background { rgb <0, 0, Sky> }
camera { location <Eye + clock, 2, -6> look_at <0, 1, 0> angle 50 }
#declare I = 0;
#while (I < Lamps)
  light_source { <4 - 0.4 * I, 5, -4> rgb Lamp / Lamps }
  #declare I = I + 1;
#end
#default { finish { ambient 0 diffuse 0.8 } }
plane { y, 0 pigment { rgb Wall } }
plane { z, 3 pigment { rgb <1, 0.5, 0.4> } }
sphere { <Ball + Move * clock, 1, 0>, 1 pigment { rgb 1 } }
box { <-3, 0, -1>, <-1.5, 2, -0.9> pigment { rgbf <0.4, 0.9, 0.5, Pane> } }

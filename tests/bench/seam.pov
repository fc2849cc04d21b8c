// One light split over Count lamps in the same place: the picture must not tell.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
#ifndef (Count) #declare Count = 1; #end
camera { location <0, 3, -7> look_at 0 angle 40 }
#declare I = 0;
#while (I < Count)
  light_source { <-6, 8, -9> rgb 1 / Count }
  #declare I = I + 1;
#end
plane { y, -1 pigment { checker rgb 0.8 rgb 0.3 }
  finish { ambient 0.1 diffuse 0.7 } }
sphere { <-1.5, 0, 0>, 1 pigment { rgb <0.8, 0.5, 0.3> }
  finish { phong 0.5 reflection 0.2 ambient 0.1 } }
box { <0.5, -1, -1>, <2, 1, 0.5> pigment { rgbt <0.3, 0.8, 0.3, 0.6> }
  finish { phong 0.5 ambient 0.1 } interior { ior 1.5 } }

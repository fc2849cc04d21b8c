// In a loop a warning is given once.
#version 3.7;
global_settings { assumed_gamma 1 }
#for (I, 1, 9)
  sphere { 0, -I }
  #declare A = I/0;
  #warning concat("round ", str(I, 0, 0), "\n")
  #if (I > 2) #break #end
#end
#macro M() #warning "in a macro" #end
M() M()

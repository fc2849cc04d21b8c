// Another name is counted than the one that is asked for.
#declare I = 0;
#declare J = 0;
#while (I < 10)
  #declare J = J + 1;
#end

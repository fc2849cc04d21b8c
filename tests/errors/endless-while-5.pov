// It counts the wrong way.
#declare I = 0;
#while (I < 10)
  #declare I = I - 1;
#end

#declare I = 0;
#while (I < 10) sphere { I, 1 } #end

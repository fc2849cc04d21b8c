#macro Ball(Place) sphere { Place, 1 } #end
#declare I = 0;
#while (I < 6
    Ball(I)
    #declare I = I + 1;
#end

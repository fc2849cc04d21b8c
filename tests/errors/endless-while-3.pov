// The counter is forgotten; what else is declared is the same each time.
#macro Ball(Place, R) #local Q = R * 2; sphere { Place, Q } #end
#declare I = 0;
#while (I < 6)
    #local P = <cos(I), sin(I), 0>;
    #declare Name = concat("ball ", str(I, 0, 0));
    Ball(P, .4)
#end

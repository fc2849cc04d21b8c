// Declare= sets a number before the first line; the first one wins.
// compare: exact
// options: Declare=Count=5 Declare=Count=9 Declare=Tilt=-22.5
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -8> right 4/3*x look_at <0, .8, 0> angle 42 }
light_source { <-5, 9, -6>, rgb 1 }
#ifndef (Count) #declare Count = 2; #end
#ifndef (Tilt) #declare Tilt = 0; #end
#ifndef (Third) #declare Third = .6; #end
#declare I = 0;
#while (I < Count)
    box { <-.3, 0, -.3>, <.3, 1.2, .3> rotate Tilt*z translate <I - 2, Third, 0>
        pigment { rgb <.9, I/Count, .2> } }
    #declare I = I + 1;
#end
plane { y, -.01 pigment { rgb .6 } }

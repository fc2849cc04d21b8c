// #while, #for, #break, nested, and #if #else #elseif by nesting; counters
// that are not whole numbers.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 6, -8> right 4/3*x look_at <0, 0, 0> angle 45 }
light_source { <-5, 9, -6>, rgb 1 }
#declare I = 0;
#while (I < 7)
    #declare J = 0;
    #while (1)
        #if (J >= 5) #break #end
        #if (mod(I + J, 3) = 0)
            sphere { <I - 3, .3, J - 2.5>, .3 pigment { rgb <.9, I/7, .2> } }
        #else
            #if (J > 2 & !(I = 3))
                box { <I - 3.2, 0, J - 2.7>, <I - 2.8, .5, J - 2.3>
                    pigment { rgb <.2, .7, J/5> } }
            #else #if (I != 1 | J = 0)
                cone { <I - 3, 0, J - 2.5>, .3, <I - 3, .6, J - 2.5>, 0
                    pigment { rgb <.5, .4, .9> } }
            #end #end
        #end
        #declare J = J + 1;
    #end
    #declare I = I + 1;
#end
#for (A, 0, 6.2, .4)
    sphere { <2*cos(A), 1.6 + .2*A, 2*sin(A)>, .12 pigment { rgb <1, .8, .3> } }
#end
#for (B, 3, -3, -1.5)
    cylinder { <B, 0, -3.4>, <B, .8, -3.4>, .1 pigment { rgb .9 } }
#end
plane { y, -.01 pigment { rgb .6 } }

// rand and seed: the very numbers of POV-Ray, two streams side by side.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 7, -7> right 4/3*x look_at <0, 0, 0> angle 45 }
light_source { <-5, 9, -6>, rgb 1 }
#declare A = seed(42);
#declare B = seed(-3.7);
#declare I = 0;
#while (I < 45)
    sphere { <6*rand(A) - 3, .2, 5*rand(A) - 2.5>, .1 + .2*rand(B)
        pigment { rgb <rand(A), rand(B), .3> } }
    #declare I = I + 1;
#end
#declare A = seed(0);
#declare Skip = rand(A) + rand(A);
box { <-3.4, 0, -3.2>, <-3.4 + 3*Skip, .3, -3> pigment { rgb <.9, rand(A), .2> } }
plane { y, -.01 pigment { rgb .6 } }

camera { <0, 1, -5> look_at 0 }
sphere { 0, 1 interior { 1.5 } }
sphere { 0, 1 finish { metalic } }
#declare A = array[3] = { 1, 2, 3 };
#version "3.7";
#debug "a" + str(5, 0, 0)
Later(1)
sphere { 0, Size }
#fopen F "x.txt" wrte
sphere { 0, 1 pigment { Stripe } }
#macro Later(A) sphere { 0, A } #end
#declare Size = 5;
#declare Stripe = pigment { gradient x }
sphere { 0, Size wrong }

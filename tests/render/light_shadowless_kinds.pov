// A light is a spotlight, a cylinder or shadowless: the last word counts. What was
// a cylinder stays parallel; parallel lights have no cone.
// compare: exact
#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0, 6, -14> look_at <0, 0, 1> angle 45 }
#macro Stage(X, Z) plane { y, -1 pigment { rgb 1 } clipped_by { box { <X - 1.9, -2, Z - 1.9>, <X + 1.9, 2, Z + 1.9> } } }
  sphere { <X, -.4, Z>, .5 pigment { rgb 1 } finish { phong .6 } } #end
#macro Lit(N)
  #local X = (mod(N, 3) - 1) * 4; #local Z = div(N, 3) * 4 - 2;
  light_group { light_source { <X + 2, 5, Z - 2> .7
  #switch (N)
    #case (0) spotlight point_at <X, -1, Z> radius 10 falloff 15 shadowless #break
    #case (1) shadowless spotlight point_at <X, -1, Z> radius 10 falloff 15 #break
    #case (2) cylinder point_at <X, -1, Z> radius .7 falloff 1 shadowless #break
    #case (3) shadowless cylinder point_at <X, -1, Z> radius .7 falloff 1 #break
    #case (4) shadowless spotlight point_at <X, -1, Z> radius 10 falloff 15 parallel #break
    #case (5) cylinder point_at <X, -1, Z> radius .4 falloff .6 spotlight #break
  #end }
  Stage(X, Z) global_lights off }
#end
#for (I, 0, 5) Lit(I) #end

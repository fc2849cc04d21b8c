// flatness: parts of a patch that are flat are not halved further.
// compare: exact
#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0,4,-5> look_at <0,0.5,0> angle 45 }
light_source { <-5,8,-6> rgb 1 }
light_source { <5,4,-6> rgb 0.4 }
plane { y,-0.2 pigment { checker rgb 0.8 rgb 0.4 } }

bicubic_patch { type 1 flatness 0.1 u_steps 4 v_steps 4 <-1,0,-1>,<-0.3,1,-1>,<0.3,1,-1>,<1,0,-1> <-1,1,-0.3>,<-0.3,2,-0.3>,<0.3,2,-0.3>,<1,1,-0.3> <-1,1,0.3>,<-0.3,2,0.3>,<0.3,2,0.3>,<1,1,0.3> <-1,0,1>,<-0.3,1,1>,<0.3,1,1>,<1,0,1> pigment { checker rgb 1 rgb x scale 0.2 } finish { phong 1 } }

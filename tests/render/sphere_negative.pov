// Spheres with a negative radius are seen in intersections and differences alone.
// compare: exact
#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0,4,-5> look_at <0,0,0> angle 45 }
light_source { <-5,8,-6> rgb 1 }
sphere { <-1.5,0,0>, -0.5 pigment { rgb x } }
union { sphere { <-1,1,0>, -0.5 } box { <-1.6,0.8,0>,<-1.2,1.2,0.4> } pigment { rgb 1 } }
difference { box { -0.5, 0.5 pigment { rgb y } } sphere { -0.5, -0.4 pigment { rgb x } } }
intersection { box { -0.5, 0.5 pigment { rgb z } } sphere { 0, -0.6 pigment { rgb x } } translate 1.5*x}

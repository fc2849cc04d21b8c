// A blob whose threshold is 0 is whole: POV-Ray draws specks, and what is meant
// where the threshold is hardly more.
// compare: exact
#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0,2,-6> look_at 0 angle 55 }
light_source { <5,8,-10> 1 }
background { rgb .2 }
#ifdef (Glim) #declare Least = 0; #else #declare Least = 1e-6; #end
blob {
  threshold Least
  sphere { <-1,0,0>, 1.5, 1 pigment { rgb x } }
  sphere { <1,0,0>, 1.5, 2 pigment { rgb y } }
  cylinder { -2*y, 2*y, .7, 1 }
  sphere { <0,2,0>, .8, -1 }
  pigment { rgb <1,.5,0> }
}
difference {
  box { <-2.8,-1.8,-1>, <-1.2,-1,0> }
  blob { threshold Least sphere { <-2,-1,-1>, .8, 3 } }
  pigment { rgb <.5,.7,1> }
}

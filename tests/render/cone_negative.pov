// Cones with negative radii: of two below 0 a cylinder of the lesser, none where
// one is 0 and the other below; through 0 where the signs differ. POV-Ray's box
// around one has the greater radius, which cuts it where the negative one is
// farther from 0: that is not compared.
// compare: exact
#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0,3,-7> look_at <0,0,0> angle 45 }
light_source { <-5,8,-6> rgb 1 }
plane { y, -1 pigment { checker rgb .8 rgb 1 } }
cone { <-2,-.8,1>, -1, <-2,1,1>, -0.4 pigment { rgb x } }
cone { <-1,-.8,1>, -0.4, <-.6,1,1>, -1 open pigment { rgb y } }
cone { <.5,-.8,1>, 0, <.5,1,1>, -0.4 pigment { rgb z } }
cone { <1.2,-.8,1>, .6, <1.2,1,1>, -0.4 pigment { rgb x+y } }
cone { <2.5,-.8,1>, .6, <2.5,1,1>, -0.6 open pigment { rgb x+z } }
difference {
  box { -0.5, 0.5 pigment { rgb y } }
  cone { -z, -0.3, z, -0.5 pigment { rgb x } }
  translate -2*z-x
}
intersection {
  box { -0.5, 0.5 pigment { rgb z } }
  cone { -z, -0.6, z, 0.5 pigment { rgb x } }
  translate -2*z+x
}

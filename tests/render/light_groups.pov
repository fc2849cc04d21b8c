// Light groups: their lamps light their objects alone, whose shadows and those
// of others count; global_lights; groups that are declared and moved.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0,4,-6> look_at <0,.5,0> angle 50 }
light_source { <-5,8,-6> rgb .5 }
#declare Group = light_group {
  light_source { <0,4,-1> rgb x*2 }
  sphere { <-1,.5,0>,.6 pigment { rgb 1 } finish { phong .6 } }
  union { box { <-2,-.1,-1>,<.2,0,1> } sphere { <-.2,.2,-.8>, .2 } pigment { rgb 1 } }
}
light_group { Group }
light_group { Group rotate 180*y scale .8 translate .3*z global_lights on }
sphere { <-.7,1.6,-.3>,.3 pigment { rgb 1 } }
sphere { <0,.3,-1.8>,.5 pigment { rgb 1 } }
plane { y,-.2 pigment { checker rgb .8 rgb .4 } }

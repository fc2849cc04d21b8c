// Gears turned by the clock: differences built in loops.
// compare: exact
// options: +K0.31
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0,0,-10> look_at 0 angle 40 }
light_source { <-6,8,-16> rgb 1 }
#declare Tx = array[3] { texture { pigment { rgb <.8,.6,.2> } finish { metallic phong 1 } }, texture { pigment { rgb <.6,.6,.7> } finish { specular 1 roughness .05 } }, texture { pigment { rgb <.7,.3,.2> } } }
#macro Gear(N, R)
 difference {
  union { cylinder { -z*0.2, z*0.2, R } #for (I,1,N) box { <-R*pi/N/2, R*0.9, -0.2>, <R*pi/N/2, R+0.25, 0.2> rotate z*360*I/N } #end }
  cylinder { -z, z, R*0.2 }
  #for (I,1,5) cylinder { -z, z, R*0.17 translate x*R*0.55 rotate z*72*I } #end
 }
#end
object { Gear(16, 1.2) texture { Tx[0] } rotate z*clock*360 translate -x*1.35 }
object { Gear(16, 1.2) texture { Tx[1] } rotate z*(-clock*360+11.25) translate x*1.35 }
object { Gear(8, 0.6) texture { Tx[2] rotate y*30 } rotate z*clock*720 translate <0,2.2,0> }

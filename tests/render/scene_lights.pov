// One scene with every kind of lamp, light_group, no_image and no_reflection.
// compare: exact
#version 3.7;
#include "colors.inc"
#include "rad_def.inc"
global_settings { assumed_gamma 1 }
camera { location <0, 5, -10> look_at <0,0.5,0> angle 45 }
#declare Bulb = union { sphere { 0, 0.2 pigment { rgb <1,1,.6> } finish { ambient 1 diffuse 0 } } cylinder { -y*0.4, 0, 0.1 pigment { Gray40 } } }
light_source { 0, rgb <1,.9,.6>*0.8 looks_like { Bulb } fade_distance 4 fade_power 1 translate <-2,2,0> }
light_source { <4,6,-4>, rgb <.4,.6,1> cylinder radius 1 falloff 1.6 tightness 0 point_at <1,0,0> }
light_source { <0,8,-2> rgb 0.5 area_light 2*x, 2*z, 5, 5 circular orient adaptive 0 }
light_source { <-8,3,-4> rgb <.6,.3,.3> spotlight radius 12 falloff 16 tightness 20 point_at <2,0.6,1> media_attenuation on }
light_group {
  light_source { <3,3,-3> rgb <.2,1,.2> }
  sphere { <3,0.6,-1>, 0.6 pigment { White } }
  global_lights off
}
cylinder { 0, y*2, 0.3 pigment { rgb <.8,.8,.9> } translate <1,0,1> }
sphere { <-1,0.7,-1.5>, 0.7 pigment { rgbf <.9,.5,.5,.6> } finish { specular .7 roughness 0.01 } }
box { <-4,0,1.4>, <-3,1.4,2> pigment { rgb 0.9 } finish { diffuse albedo 0.7 phong albedo 0.3 } no_reflection }
box { <2.4,0,0.4>, <2.8,2,1.6> pigment { rgb <.4,.8,.4> } no_image }
plane { y, 0 pigment { checker rgb 0.95 rgb 0.75 } finish { reflection { 0.15 exponent 0.7 } } }

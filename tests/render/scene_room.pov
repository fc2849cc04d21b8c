// A room as a difference, with a table built in a loop and lamps.
// compare: exact
#version 3.6;
#include "colors.inc"
#include "metals.inc"
#include "woods.inc"
global_settings { max_trace_level 8 ambient_light rgb 0.6 assumed_gamma 1.8 }
camera { location <-2.6, 1.7, -2.7> look_at <1, 1, 1.2> angle 70 }
#local Thick = 0.2;
#declare Room = difference {
  box { <-3-Thick, -Thick, -3-Thick>, <3+Thick, 2.8+Thick, 3+Thick> }
  box { <-3, 0, -3>, <3, 2.8, 3> }
  box { <-0.8, 0.9, 2.9>, <0.8, 2.1, 4> texture { pigment { White } } }
  cylinder { <2, 1.5, 0>, <4, 1.5, 0>, 0.5 }
  texture { pigment { wood turbulence 0.04 color_map { [0 rgb <.9,.8,.6>] [1 rgb <.7,.6,.45>] } scale 0.3 rotate x*90 } }
};
object { Room }
#declare Leg = cylinder { 0, y*0.7, 0.04 texture { T_Brass_3B } }
#declare Table = union {
  box { <-0.7, 0.7, -0.4>, <0.7, 0.76, 0.4> texture { T_Wood7 rotate y*90 scale 0.5 } }
  #local I = -1;
  #while (I <= 1)
    object { Leg translate <0.62*I, 0, -0.33> } object { Leg translate <0.62*I, 0, 0.33> }
    #local I = I + 2;
  #end
}
object { Table translate <0.8, 0, 1.2> }
intersection { sphere { 0, 0.25 } sphere { 0, 0.24 inverse } plane { y, 0.1 } bounded_by { sphere { 0, 0.26 } } pigment { rgbf <.9,.95,1,.8> } finish { F_MetalA reflection 0.1 } interior { ior 1.5 } translate <0.8, 1.02, 1.2> }
light_source { <0, 2.6, 0> color White*0.7 fade_distance 2 fade_power 2 spotlight point_at <0.8, 0, 1.2> radius 40 falloff 70 tightness 1 }
light_source { <30, 20, 60> rgb <1, 0.9, 0.7> }

// What height fields clip: they have an inside below all of their surface. Of
// things without end, what is down there is only seen by rays that come through
// the height field's box.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 7, -13> angle 40 look_at <0, -.5, 0> }
light_source { <10, 50, -30> 1 }
#declare Hills = height_field {
  function 30, 30 { .5 + .2*sin(x*26)*cos(y*25) }
  translate <-.5, 0, -.5> scale <4, 2, 4> }
#declare Bands = pigment { gradient y
  color_map { [0 rgb <1, .2, 0>] [1 rgb <0, .4, 1>] } }
#declare Endless = quadric { <1, 0, 1>, 0, 0, -1 }
#default { pigment { Bands } }
object { Endless clipped_by { Hills } translate -3.6*x }
plane { z, .5 rotate x*20 clipped_by { Hills } translate 3.9*x }

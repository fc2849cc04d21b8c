// A torus with a negative minor radius has an inside, and no surface.
// compare: exact
#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0,4,-5> look_at <0,0,0> angle 45 }
light_source { <-5,8,-6> rgb 1 }
torus { 1, -0.3 pigment { rgb x } }
difference { box { -0.9, 0.9 pigment { rgb y } } torus { 1, -0.4 pigment { rgb x } } }
intersection { box { -0.5, 0.5 pigment { rgb z } } torus { 1, -0.4 pigment { rgb x } } translate 1.5*x}

// Two rooms and a passage between them; the lamp is in the first, and the
// camera sees the second, where light comes round a corner.
#version 3.7;
global_settings { assumed_gamma 1 }
#default { pigment { rgb <.9, .7, .5> } finish { ambient 0 diffuse .7 } }
camera { location <4.9, 1.2, .2> look_at <3.5, .6, 2> right 4/3*x angle 80 }
light_source { <1, 1.5, .6>, <8, 7, 6> fade_distance .5 fade_power 2 }
difference {
  box { <-.2, -.2, -.2>, <5.2, 2.2, 3.2> }
  box { <0, 0, 0>, <2, 2, 3> }
  box { <1.9, 0, 2>, <3.1, 1.6, 2.8> }
  box { <3, 0, 0>, <5, 2, 3> }
}

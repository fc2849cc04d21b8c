// Media on a ray's way are lit by lamps of a light_group where what ends the way
// is of the group, whoever holds them.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -9> look_at <0, 1, 0> angle 45 }
#declare Black = texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 } }
#declare Full = material {
  texture { pigment { rgbt 1 } }
  interior { media { scattering { 1, .2 } intervals 1 samples 8 method 3 } }
}
#declare Lamp = light_source { <0, 8, -6> rgb <1, .8, .6> }
media { scattering { 1, .01 } intervals 1 samples 8 method 3 }
plane { z, 5 texture { Black } hollow }
light_source { <8, 8, -6> rgb <0, 0, 1> }
light_group {
  light_source { Lamp }
  sphere { <-2.5, 1, 0>, 1 hollow material { Full } }
  sphere { <-2.5, 1, 0>, .5 texture { Black } }
  global_lights off
}
sphere { 1 * y, 1 hollow material { Full } }
light_group {
  light_source { Lamp }
  sphere { <.5, 1, 0>, .3 texture { Black } }
  global_lights on
}
sphere { <2.5, 1, 0>, 1 hollow material { Full } }

// The light of area_light.pov in a scene that has lamps for some of its things
// alone: then each surface asks its lamps by itself, and as finely.
// claims: rays mesh soft
//
// The values are those of area_light.pov.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <-.05, .05, -10> right 6.4*x up 4.8*y }
light_source { <0, 0, -4>, rgb 1 area_light 4*x, y, 5, 1 }
plane { -z, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
box { <.1, -9, -2.001>, <5, 9, -1.999> pigment { rgb 0 }
    finish { ambient 0 diffuse 0 } }
light_group {
  light_source { 50*y, rgb 1 }
  sphere { 99*y, 1 pigment { rgb 1 } }
  global_lights off
}

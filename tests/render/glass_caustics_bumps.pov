// caustics with a normal: bumps bend what is turned towards the light's way.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { angle 50 location <0, 5, -15> right 4/3*x look_at <0, 2, 0> }
light_source { <0, 50, 0> rgb .6 }
light_source { <0, 1, 0> rgb <.2, .1, 0> }
#default { finish { diffuse .7 } }
plane { y, 0 pigment { rgb .6 } }
plane {
  y, 10 hollow pigment { rgbf <.7, .7, 1, .9> } normal { bumps .5 }
  interior { ior 1.1 caustics 1 }
}
plane { z, 20 pigment { rgb .6 } }

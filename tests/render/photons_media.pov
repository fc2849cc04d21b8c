// Photons in media: a ball gathers a beam in haze, a lens behind smoke another,
// and both shadow the haze. Smoke dims photons whether they stay in it or not.
// compare: noise
#version 3.7;
global_settings { assumed_gamma 1 photons { spacing .03 media 300 } }
camera { location <0, 1, -9> right 4/3*x look_at <0, .3, 0> angle 42 }
light_source { <-1.5, 5, 0> rgb .7 photons { refraction on } }
#declare Glass = texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }
sphere { <-1.5, 2, 0>, .8 texture { Glass } interior { ior 1.3 }
  photons { target refraction on } }
sphere { 0, 1 scale <.8, .3, .8> translate <1.6, 2.2, 0> texture { Glass }
  interior { ior 1.5 } photons { target refraction on } }
box { <-3, -1.9, -1>, <3, .8, 1> texture { Glass } hollow
  interior { media { scattering { 1, rgb <.08, .07, .05> } method 3 samples 16 } }
  photons { pass_through } }
box { <.3, .9, -1>, <3, 1.5, 1> texture { Glass } hollow
  interior { media { absorption <.2, .9, .9> method 3 } } photons { pass_through } }
plane { y, -2 pigment { rgb .9 } finish { ambient 0 diffuse .8 } }

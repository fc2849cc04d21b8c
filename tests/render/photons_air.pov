// Media of the scene have no photons: a ball gathers light on the floor, and no
// beam in the haze around; in a box of smoke, which has some, they light both.
// compare: noise
#version 3.7;
global_settings { assumed_gamma 1 photons { spacing .03 media 200 } }
camera { location <0, 1, -9> right 4/3*x look_at <0, .3, 0> angle 42 }
light_source { <-1.5, 5, 0> rgb .7 photons { refraction on } }
#declare Glass = texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }
#declare Haze = media { scattering { 1, rgb .05 } method 3 samples 8 }
sphere { <-1.5, 2, 0>, .8 texture { Glass } interior { ior 1.3 } hollow
  photons { target refraction on } }
sphere { 0, 1 scale <.8, .3, .8> translate <1.6, 2.2, 0> texture { Glass }
  interior { ior 1.5 } hollow photons { target refraction on } }
box { <.4, -1.9, -1>, <3, .8, 1> texture { Glass } hollow
  interior { media { Haze scattering { 1, rgb <.04, .03, .01> } } }
  photons { pass_through } }
plane { y, -2 pigment { rgb .9 } finish { ambient 0 diffuse .8 } }
plane { -z, -5 pigment { rgb .5 } finish { ambient 0 diffuse .8 } }
media { Haze }

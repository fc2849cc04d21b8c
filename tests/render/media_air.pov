// Media everywhere: a spot's beam, met at its edges; a cylinder light; what
// shadowless lights and media_attenuation do; a ball hollow and one not.
// compare: exact
// options: +W80 +H60
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, .8, 0> angle 50 }
light_source { <-3, 5, 0> rgb 2 spotlight point_at <-1, 0, 0> radius 10 falloff 12 }
light_source { <3, 5, 0> <.5, .8, 1> cylinder point_at <1, 0, 0> radius .4 falloff .5 media_attenuation on }
light_source { <0, 9, -9> rgb .4 shadowless }
plane { y, -1 hollow pigment { checker rgb .8 rgb .4 } }
media { scattering { 1, rgb .12 extinction .7 } emission <0, .003, .006> intervals 4 samples 4 ratio .8 }
sphere { <-1.4, 1, 0>, .4 hollow pigment { rgb 1 } }
sphere { <1.6, 1, -.3>, .4 pigment { rgbt .9 } }

// Light scattered by media, of all five types, in balls and a glass box with
// fog around; shadows of media and in media.
// compare: exact
// options: +W80 +H60
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, .3, 0> angle 50 }
light_source { <-5, 8, 6> rgb 1.5 }
light_source { <6, 3, -4> rgb <.6, .7, 1> media_interaction off }
plane { y, -1 hollow pigment { rgb .7 } }
fog { distance 60 rgb <.5, .6, .7> }
#declare Ball = sphere { 0, .6 hollow pigment { rgbt 1 } }
object { Ball interior { media { scattering { 1, rgb 1 } } } translate <-2.4, 0, 0> }
object { Ball interior { media { scattering { 2, rgb 1 } } } translate <-1.2, 0, 0> }
object { Ball interior { media { scattering { 3, <1, .5, .3> } } } translate <0, 0, 0> }
object { Ball interior { media { scattering { 4, rgb 2 extinction .4 }
  density { spherical turbulence .4 } } } scale 1.2 translate <1.2, 0, 0> }
object { Ball interior { media { scattering { 5, rgb 1 eccentricity .6 } absorption <0, 1, 2> } } translate <2.4, 0, 0> }
box { <-.7, -.9, -3>, <.7, -.3, -2> hollow pigment { rgbf .9 } finish { reflection .1 }
  interior { ior 1.3 media { scattering { 4, rgb .6 } emission .1 absorption .2 } } }

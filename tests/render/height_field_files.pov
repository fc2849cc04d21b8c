// Heights from a GIF, from a POT, from colours of 16 bits.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4, -6> look_at 0 angle 40 }
light_source { <-5, 8, -6>, 1 }
#default { pigment { rgb <.9, .6, .3> } finish { ambient .1 } }
height_field { gif "parts/heights.gif" scale <1.2, .4, 1.2> translate <-2, 0, -.6> }
height_field { pot "parts/heights.pot" smooth scale <1.2, .4, 1.2> translate <-.6, 0, -.6> }
height_field { png "parts/colour16.png" premultiplied off scale <1.2, .4, 1.2> translate <.8, 0, -.6> }

// Lamps that are in a medium themselves: it does not weaken them from the last
// surface on.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -3*z look_at 0 angle 60 }
light_source { <3, 0, -1> rgb .6 }
light_source { <-2, 5, -1> rgb <.1, .2, .4> media_attenuation on }
#declare Veil = texture { pigment { rgbf 1 } finish { ambient 0 diffuse 0 } }
#declare Smoke = media { scattering { 1, .3 } absorption .3 intervals 3 method 3 }
sphere { 0, 4 hollow texture { Veil } interior { media { Smoke } } }
sphere { <0, 0, 1>, 1.5 hollow texture { Veil } }
sphere { <-.5, 0, 1>, .3 pigment { rgb 1 } }
sphere { <.5, 0, 0>, .3 pigment { rgb 1 } }
fog { distance 20 rgb .1 }

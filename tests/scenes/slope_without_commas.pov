// The first comma of slope's ranges may be left out.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -3*z look_at 0 }
light_source { <-5, 8, -6>, 1 }
sphere { 0, 1 pigment { slope { y 0, 1 altitude y .3, 1 } } }

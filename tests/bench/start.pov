// Bench: as little as a scene can be; measures starting and ending.
#version 3.7;
global_settings { assumed_gamma 1 }
light_source { <-2, 3, -2> rgb 1 }
sphere { 3*z, 1 pigment { rgb <0.8, 0.5, 0.2> } }

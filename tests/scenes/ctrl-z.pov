#version 3.7;
global_settings { assumed_gamma 1 }
// DOS editors end a text with Ctrl-Z, and fill the last block of it.
sphere { 0, 1 pigment { rgb 1 } }

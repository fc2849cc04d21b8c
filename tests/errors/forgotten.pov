#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5*z }
camera { location -6*z }
light_source { 5*y, 1 }
difference { sphere { 0, 1 } pigment { rgb 1 } }
difference { pigment { rgb 1 } }
difference { sphere { 0, 1 } sphere { y, 1 } }
oops

// What POV-Ray warns of and goes on with, or lets pass.
#version 3.7;
global_settings { assumed_gamma 1 photons { spacing 0 } }
camera { location -5*z look_at 0 }
light_source { <5, 9, -5>, 1 }
fog { fog_type 3 distance 10 rgb 1 }
sphere { 0, 1 hollow pigment { rgbt 1 }
  interior { media { scattering { 6, 0.1 } } } }
blob { threshold -1 sphere { 0, 1, 1 } }

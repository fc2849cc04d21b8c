// Focal blur makes edges in focus smooth as well: its rays are of all the pixel.
// compare: noise
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5*z look_at 0 angle 40 aperture .01 focal_point 0
  blur_samples 100 confidence .999 variance 1/100000 }
plane { z, 0
  pigment { checker rgb 0 rgb 1 scale .15 rotate 17*z }
  finish { ambient 1 diffuse 0 } }

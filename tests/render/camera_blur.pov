// Focal blur: near and far things out of focus, by 37 rays for each pixel.
// compare: noise
// options: +W80 +H60
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0,2,-5> look_at 0 right 4/3*x focal_point <-.5,.5,0> aperture .8 blur_samples 37 confidence .95 variance 0 }
light_source { <-5,8,-6> rgb 1 }
sphere { 0, 1 pigment { rgb <.9,.3,.1> } }
box { <-2.5,-1,-1>, <-1.2,1,1> pigment { checker rgb 1 rgb .3 scale .4 } }
box { <.8,-1,-3>, <1.2,.5,-2> pigment { rgb <.1,.3,.9> } }
plane { y,-1 pigment { checker rgb .8 rgb .4 } }

// A point after the last outline of a prism of splines, which would begin another,
// is left out. One Bezier piece that ends where it began is an outline.
// compare: exact
#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0,2,-6> look_at 0 angle 55 }
light_source { <5,8,-10> 1 }
background { rgb .2 }
prism { cubic_spline 0,1,9, <-.5,-1>,<0,-1>,<1,0>,<.6,.8>,<-.6,.8>,<-1,0>,<0,-1>,<1,0>,
  <1,1> pigment { rgb x } rotate -50*x translate -1.5*x }
prism { quadratic_spline 0,1,8, <-.5,-1>,<0,-1>,<1,0>,<.6,.8>,<-.6,.8>,<-1,0>,<0,-1>,
  <1,1> pigment { rgb y } rotate -50*x translate 1.5*x }
prism { bezier_spline 0, .5, 4, <-.6,-.3>, <1,-.6>, <.6,.8>, <-.6,-.3>
  pigment { rgb z } rotate -50*x translate -1.4*y }

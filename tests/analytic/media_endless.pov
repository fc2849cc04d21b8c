// Media of the scene, which have no end: all that is seen has been scattered
// there, once, and so is as bright as the lamp. The second time, and all after
// it, would bring as much again, without end: lamps don't fade. Rays, as in
// POV-Ray, look at too few places of such a way.
// claims: path
// options path: --samples 64
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -10*z right 6.4*x up 4.8*y }
light_source { 1000*y, rgb <.5, .3, .1> }
media { scattering { 1, .1 } }

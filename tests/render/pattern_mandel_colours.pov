// mandel without a map has colours of its own.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <-.6, 0, -5> right 2.8*x up 2.1*y look_at <-.6, 0, 0> }
plane { z, 0 pigment { mandel 150 } finish { ambient 1 diffuse 0 } }

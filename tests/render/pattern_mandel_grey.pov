// mandel of another exponent than 2 has no colours of its own without a map.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5 * z right 2.8*x up 2.1*y look_at 0 }
plane { z, 0 pigment { mandel 20 exponent 3 } finish { ambient 1 diffuse 0 } }

// A threshold that is met exactly counts as passed.
// compare: exact
// options: +A0.5 +R2 -J Antialias_Gamma=1.0
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> look_at 0 angle 50 }
sphere { 0, 2 pigment { rgb <0.5, 0, 0> } finish { ambient 0 diffuse 0 emission 1 } }

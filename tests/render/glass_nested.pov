// fresnel where bodies overlap: leaving one of several, what was entered last
// counts as what lies behind.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 12 }
camera { location <20, 4.6, 10> right x*4/3 look_at <0, 2, 0> angle 24 }
light_source { <-10, 7, 18> rgb 1 }
plane { y, -.5 pigment { checker rgb .95 rgb .4 } }
sphere { 0, 100 hollow pigment { rgb .95 } finish { ambient 1 diffuse 0 } }
#default { finish { diffuse 0 reflection { 0, 1 fresnel } } }
box { <-1, 0, 0>, <1, 2.4, 2.4> pigment { rgbt 1 } interior { ior 1.5 } }
sphere { <0, 2, .5>, 1.2 pigment { rgbt 1 } interior { ior 1.2 } }
sphere { <0, 2, -2>, 1.6 pigment { rgbt 1 } interior { ior 1.9 } }
sphere { <0, 2, -2>, .8 pigment { rgbt 1 } }

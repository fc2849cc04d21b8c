// Old scenes: ior and caustics said in the finish; a prism that is not closed,
// an object after a '#' and a declaration without one.
// compare: exact
#version 3.1;
global_settings { assumed_gamma 1 max_trace_level 6 }
camera { location <0, 4, -7> right 4/3*x look_at <0, .3, 0> angle 45 }
light_source { <-4, 9, -8>, rgb .8 }
#declare Glass = texture {
    pigment { rgbf .9 } finish { refraction 1 ior 1.3 caustics 1 }
}
declare Size = .8;
plane { y, 0 pigment { rgb 1 } }
sphere { <-1.5, .9, 0>, Size texture { Glass } }
#prism { linear_spline 0, .7, 3, <.3, 0>, <1, 1.6>, <2, 0> pigment { rgb x } }

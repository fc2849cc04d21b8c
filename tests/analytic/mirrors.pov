// Two mirrors face to face: max_trace_level counts the surfaces of a chain.
// claims: rays path mesh soft
//
// The view goes straight back and forth between a wall at z = 0 and one behind
// the camera. Each glows .2 and reflects .5: .2 (1 + .5 + .25 + ...), of
// max_trace_level 6 terms: .2 (1 - .5^6)/(1 - .5) = .39375.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 0 }
camera { orthographic location <-.05, .05, -10> right 6.4*x up 4.8*y }
#default { pigment { rgb 1 }
    finish { ambient 0 diffuse 0 emission .2 reflection .5 } }
plane { -z, 0 }
plane { z, -20 }

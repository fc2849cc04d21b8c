// max_trace_level ends a chain of mirrors; adc_bailout ends it earlier where
// the weight is small: that of a mirror that is stronger at an angle counts as if
// it was seen so.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 adc_bailout .1 }
camera { location <.6, .5, -2.6> right 4/3*x look_at <-.3, .1, 1> angle 75 }
light_source { <-.5, 1.6, -2>, rgb 1 }
background { rgb <.9, .5, .2> }
plane { -z, -2 pigment { rgb .12 } finish { reflection .95 } }
plane { z, -3.2 pigment { rgb <.1, .2, .4> } finish { reflection .8 } }
plane { x, -1.5 pigment { rgb <.1, .3, .1> } finish { reflection .25 } }
sphere { <-.4, 0, .6>, .5 pigment { rgb <.9, .3, .3> } finish { reflection .3 } }
sphere { <.6, -.3, 0>, .3 pigment { rgb <.9, .9, .3> } }
plane { y, -.7 pigment { checker rgb .8, rgb .4 scale .6 translate .23 } }
sphere { <-.1, -.5, -.7>, .2 pigment { rgb <.1, .1, .4> }
    finish { reflection { .02, .5 } } }
sphere { <.2, .1, .9>, .3 pigment { rgb <.1, .3, .1> }
    finish { reflection { .5, .02 falloff 2 } } }
sphere { <-1, -.4, 1.2>, .3 pigment { rgb <.4, .1, .1> }
    finish { reflection { .02, .5 fresnel } } interior { ior 1.5 } }

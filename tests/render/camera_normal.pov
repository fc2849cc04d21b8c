// A camera's normal bends its rays, turned with nothing.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera {
    location <0, 2, -6> look_at 0 right 1.6 * x rotate 10 * y
    normal { ripples .3 frequency 9 phase .2 scale .8 translate <.1, .2, 0> }
}
light_source { <-5, 8, -6>, 1 }
sphere { 0, 1 pigment { rgb <.9, .6, .3> } }
plane { y, -1 pigment { checker rgb .8 rgb .4 } }

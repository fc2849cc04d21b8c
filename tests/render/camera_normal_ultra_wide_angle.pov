// A camera's normal bends the rays of those that turn by its value at angles.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera {
    ultra_wide_angle location <0, 2, -6> look_at <0, 1, 1> right 1.6 * x up 1.2 * y
    angle 100 normal { bumps .3 scale .3 }
}
light_source { <-5, 8, -6>, 1 }
sphere { <0, 1, 0>, 1 pigment { rgb <.9, .6, .3> } }
plane { y, -1 pigment { checker rgb .8 rgb .4 } }

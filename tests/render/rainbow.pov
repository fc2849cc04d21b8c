// Rainbows: an arc that fades at its ends before a sky, ground and a ball,
// another whole circle in it that transmits; in a mirror.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -8> right 4/3*x look_at <0, 2.5, 0> angle 80 }
light_source { <-4, 8, -9>, rgb 1 }
background { rgb <.1, .2, .5> }
rainbow { angle 30 width 8 distance 25 direction <-.1, -.1, 1>
    arc_angle 150 falloff_angle 60 up <.3, 1, 0>
    color_map { [0 rgbt <1, 0, 0, .7>] [.4 rgb <1, 1, 0>] [.7 rgbf <0, 1, 0, .5>] [1 rgbt 1] } }
rainbow { direction z angle 14 width 6 distance 1e7 arc_angle 360 falloff_angle 360
    colour_map { [0 rgbt <1, 1, 1, .9>] [1 rgbt <0, 0, 1, .4>] } }
plane { y, 0 pigment { checker rgb .8, rgb .3 scale 2 } }
sphere { <2, 2, 3>, 2 pigment { rgb .2 } finish { reflection .6 } }

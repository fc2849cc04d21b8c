// Rainbows: how much there is of the circle, and what is full, said or not.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location 0 direction z up 1.2*y right 1.6*x }
sphere { 0, 100 pigment { rgb .2 } finish { ambient 1 } hollow }
#macro Bow()
    angle 8 width 4 distance 30
    color_map { [0 rgbt <1, 1, 0, .3>] [1 rgbt <0, 1, 1, .3>] }
#end
rainbow { direction <-.5, .3, 1> Bow() }
rainbow { direction <0, .3, 1> arc_angle 180 Bow() }
rainbow { direction <.5, .3, 1> falloff_angle 90 Bow() }
rainbow { direction <-.5, -.3, 1> arc_angle 90 Bow() }
rainbow { direction <0, -.3, 1> arc_angle 360 falloff_angle 90 Bow() }
rainbow { direction <.5, -.3, 1> arc_angle 360 Bow() }

#version 3.7;
global_settings { assumed_gamma 1 }
rainbow { angle 42 width 5 distance 1e7 color_map { [0 rgbt 1] [1 rgb 1] } }
rainbow { direction z width 5 distance 1e7 color_map { [0 rgbt 1] [1 rgb 1] } }
rainbow { direction z angle 42 width 5 distance 1e7 }
rainbow { direction z angle 42 width 5 distance 1e7 arc_angle 20
    falloff_angle 30 color_map { [0 rgbt 1] [1 rgb 1] } }
rainbow { direction z colour 3 }
sphere { 0, 1 finish { irid { thickness 2 } } }
sphere { 0, 1 finish { irid { .5 thick 2 } } }

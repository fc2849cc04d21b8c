// interior_texture before the texture of the outside, and in a material alone.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> right 4/3*x look_at 0 angle 45 }
light_source { <-5, 8, -7>, rgb 1 }
#declare Lined = material { interior_texture { pigment { rgb y } } }
sphere { 0, 1.2
    interior_texture { pigment { rgb z } } pigment { rgb x }
    clipped_by { plane { -z, 0 } } translate -1.3*x }
sphere { 0, 1.2 material { Lined } pigment { rgb <1, .5, .2> }
    clipped_by { plane { -z, 0 } } translate 1.3*x }

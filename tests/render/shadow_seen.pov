// Shadows through slope and aoi: what the ray comes from is the viewer.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -5> look_at <0, -.6, 0> }
light_source { <2, 30, 0> 1 }
light_source { <-9, 20, 0> .4 area_light 3*x, 3*z, 3, 3 }
#declare Veil = color_map { [0 rgbt 1] [.5 rgbt <1, 0, 0, .5>] [1 rgb 0] }
plane { y, -1 pigment { rgb 1 } }
sphere { <-2.2, 0, 0>, .8 pigment { aoi color_map { Veil } } }
sphere { 0, .8 pigment { slope { y } color_map { Veil } } }
box { -.6, .6 rotate <20, 0, 30> translate 2.2*x
    pigment { aoi color_map { Veil } } normal { bumps .5 scale .2 } }

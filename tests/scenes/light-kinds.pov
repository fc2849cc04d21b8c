// A light is a spotlight or a cylinder or shadowless.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5 * z }
light_source { <1, 2, -3> rgb 1 spotlight radius 10 shadowless }
light_source { <1, 2, -3> rgb 1 shadowless spotlight radius 10 }
light_source { <1, 2, -3> rgb 1 shadowless }
light_source { <1, 2, -3> rgb 1 spotlight cylinder }

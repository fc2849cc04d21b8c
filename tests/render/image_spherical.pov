// image_map round a sphere (1), a cylinder (2) and a torus (5).
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -7> right 4/3*x look_at <0, 0, 0> angle 38 }
light_source { <-4, 6, -9>, rgb 1.2 }
background { rgb .2 }
sphere { 0, 1 pigment { image_map { png "parts/flag.png" map_type 1 } }
    rotate 80*y translate -2.2*x }
cylinder { 0, y, 1 pigment { image_map { png "parts/flag.png" map_type 2 } }
    scale <.8, 1.6, .8> rotate 100*y translate <-.1, -.9, 0> }
torus { .8, .35 pigment { image_map { png "parts/flag.png" map_type 5 } }
    rotate <-50, 70, 0> translate 2*x }

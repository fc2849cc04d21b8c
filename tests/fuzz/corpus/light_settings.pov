#version 3.7;
global_settings {
    assumed_gamma 1
    light_mesh { quality 5 density 2 radius 1 interpolation nearest
        model directional shadows sharp threshold 0.1 levels 2
        indirect { samples 9 bounces 2 } region { -1, <1, 2, 3> factor 2 } }
    skeleton { resolution 32 heuristic nearest }
    radiosity { pretrace_start 0.1 pretrace_end 0.01 count 20, 30
        nearest_count 5, 3 error_bound 1 recursion_limit 2 normal on }
}
light_source { 9*y, 1 } sphere { 0, 1 pigment { rgb 1 } }

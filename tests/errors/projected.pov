#version 3.7;
global_settings { assumed_gamma 1 }
light_source { 0, 1 projected_through { sphere { 0, 1 } }
    projected_through { sphere { 0, 2 } } }
light_source { 0, 1 projected_through { 3 } }

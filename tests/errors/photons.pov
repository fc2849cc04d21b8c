#version 3.7;
global_settings { assumed_gamma 1
    photons { spacing 0 count -5 gather 20, 1e9 radius -1 density 3 } }
light_source { 0, 1 photons { refract on } }
sphere { 0, 1 photons { target -1 } }

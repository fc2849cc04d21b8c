#version 3.7;
global_settings { assumed_gamma 1 }
sphere { 0, 1 interior { ior 1.5 dispersion 0 dispersion_samples 7 } }
sphere { 0, 1 interior { ior 1.5 dispersion 1.1 dispersion_samples 1e6 } }

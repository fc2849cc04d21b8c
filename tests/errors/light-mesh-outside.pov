global_settings { assumed_gamma 1 }
light_mesh { quality 3 }

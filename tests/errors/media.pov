media { scattering { 6, rgb 1 } }
media { samples 5, 2 }
media { samples 0 }
media { aa_level 0 }
media { scattring { 1, rgb 1 } }
media { scattering { 5, rgb 1 eccentric 1 } }
media { emission 1 density { pigment_map { [0 rgb 1] } uv_mapping } }
sphere { 0, 1 interior { media { Fog } } }
sphere { 0, 1 pigment { density_map { [0 rgb 1] } } }

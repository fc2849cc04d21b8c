global_settings { ambient 1 }
global_settings { gamma 2.2 }
global_settings { radiosity { on } }
global_settings { radiosity { count = 100 } }
global_settings { radiosity { samples 50 } }
camera { orthographic width 5 }
camera { isometric }
sphere { 0, 1 interior { media { scattering { 1 } } } }
sphere { 0, 1 interior { media { scattering rgb 1 } } }
sphere { 0, 1 interior { media { scattering { isotropic, rgb 1 } } } }
sphere { 0, 1 interior { media { scattering { 1, rgb 1 eccentricity 0.5 } } } }
sphere { 0, 1 photons { target reflection refraction } }
sphere { 0, 1 finish { fresnel on } }
mesh2 { vertices { 3, 0, x, y } }
text { ttf "timrom.ttf" "A" }

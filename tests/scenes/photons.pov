global_settings { photons { count 100, media 20 spacing .01 } assumed_gamma 1 }
camera { location -3*z look_at 0 }
light_source { -5*z, 1 photons { refraction on } }
sphere { 0, 1 photons { target reflection on } }

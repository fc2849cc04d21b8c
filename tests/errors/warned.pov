camera { location -5*z look_at 0 aperture 1 focal_point 0 }
light_source { 10*y, rgb 1 area_light 5, 5, 3, 3 }
sphere { 0, 1 interior { refraction 1 } }
nothing

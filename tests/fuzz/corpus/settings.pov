// Seeds of the fuzzer, one for each part of the grammar: every word once.
#version 3.7;
global_settings {
    assumed_gamma srgb ambient_light rgb <0.1, 0.2, 0.3> max_trace_level 9
    adc_bailout 0.01 noise_generator 2 number_of_waves 10 charset utf8
    max_intersections 64 mm_per_unit 10 irid_wavelength rgb 0.5 hf_gray_16 off
}
#default { texture { pigment { rgb 1 } } pigment { rgb 0.5 }
    normal { bumps } finish { ambient 0 } }
camera { orthographic location <1, 2, -9> direction z right 1.3*x up y sky y
    angle 40 look_at 0 aperture 0 blur_samples 4, 9 focal_point x
    confidence 0.9 variance 0.01 translate y rotate 5*x scale 2 }
#declare Eye = camera { perspective location -5*z look_at <0, 1, 0> }
camera { Eye matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0> }
background { color red 0.1 green 0.2 blue 0.3 }
#declare Mist = fog { distance 9 rgbft <1, 0.5, 0, 0.1, 0.2> fog_type 1
    turb_depth 0.3 octaves 3 omega 0.4 lambda 2 up y }
fog { Mist distance 10 fog_type 1 }
#declare Sky = sky_sphere { pigment { gradient y color_map {
    [0 rgb 0] [1 color rgbt <1, 1, 1, 0.5>] } } emission rgb 2 rotate x }
sky_sphere { Sky pigment { rgbf 0.2 } }

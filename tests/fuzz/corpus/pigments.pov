#version 3.7; global_settings { assumed_gamma 1 }
#declare Map = color_map { [0 rgb 0] [0.5, 1 color rgb 0.5 color rgb 1] }
#declare Inner = pigment_map { [0 rgb 1] [0.5 wood turbulence 0.3] [1 rgb 0] }
#declare Paint = pigment { marble color_map { Map } turbulence 0.5 octaves 3
    omega 0.4 lambda 2.5 sine_wave frequency 2 phase 0.3 scale 2 rotate x }
sphere { 0, 1 pigment { Paint triangle_wave quick_color rgb 1 } }
sphere { 0, 1 pigment { gradient <1, 2, 0> pigment_map { Inner } poly_wave 2 } }
sphere { 0, 1 pigment { checker rgb 1, rgbf <1, 0, 0, 0.5> ramp_wave } }
sphere { 0, 1 pigment { hexagon rgb 1 rgb 0.5 rgb 0 } }
sphere { 0, 1 pigment { brick pigment { Paint }, pigment { rgb 0 }
    brick_size <8, 3, 4.5> mortar 0.5 } }
sphere { 0, 1 pigment { agate agate_turb 2 scallop_wave } }
sphere { 0, 1 pigment { crackle form <1, 1, 0> metric 3 offset 0.1 solid } }
sphere { 0, 1 pigment { bozo noise_generator 2 cubic_wave
    warp { turbulence <1, 2, 3> octaves 4 omega 0.5 lambda 2 } } }
sphere { 0, 1 pigment { radial } } sphere { 0, 1 pigment { onion } }
sphere { 0, 1 pigment { leopard } } sphere { 0, 1 pigment { granite } }
sphere { 0, 1 pigment { spotted } } sphere { 0, 1 pigment { bumps } }
sphere { 0, 1 pigment { dents } } sphere { 0, 1 pigment { ripples } }
sphere { 0, 1 pigment { waves } } sphere { 0, 1 pigment { wrinkles } }

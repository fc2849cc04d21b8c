#version 3.7; global_settings { assumed_gamma 1 }
#declare Bumpy = normal { bumps 0.4 accuracy 0.01 scale 0.1 }
#declare Shine = finish { ambient 0.1 emission rgb 0.2 diffuse albedo 0.6, 0.1
    brilliance 2 phong albedo 0.5 phong_size 30 specular albedo 0.4
    roughness 0.01 metallic 0.5 crand 0.1 conserve_energy
    reflection { 0.1, rgb 0.9 falloff 2 exponent 1.5 fresnel on metallic 1 } }
#declare Glass = interior { ior 1.5 fade_distance 2 fade_power 1001
    fade_color rgb <0, 1, 0> caustics 0 dispersion 1 dispersion_samples 7 }
#declare Skin = texture { pigment { rgbft <1, 0.5, 0.2, 0.3, 0.4> }
    normal { Bumpy bump_size 2 } finish { Shine diffuse 0.3 } }
#declare Block = material { texture { Skin scale 2 } interior { Glass } }
sphere { 0, 1 material { Block rotate 3 } }
sphere { 0, 1 texture { Skin } texture { pigment { rgbt 1 } } }
sphere { 0, 1 texture { Skin pigment { rgb 1 } normal { waves, 0.3 } } }
sphere { 0, 1 finish { reflection 0.5 reflection_exponent 2
    } normal { ripples 1 frequency 3 phase 0.5 } }

#version 3.7; global_settings { assumed_gamma 1 }
light_source { <1, 2, -3>, rgb 2 fade_distance 4 fade_power 2 shadowless }
light_source { 5*y, srgb <1, 0.5, 0.2> spotlight point_at <0, 1, 0>
    radius 20 falloff 30 tightness 5 translate x }
light_source { 0 color 1 cylinder point_at z radius 1 falloff 2 parallel }
light_source { <0, 9, 0>, 1 area_light 2*x, 3*z, 5, 7 adaptive 1 jitter
    circular orient area_illumination on media_attenuation yes
    media_interaction off photons { reflection on refraction off } }
#declare Lamp = light_source { 9*y, 1 looks_like { sphere { 0, 1
    pigment { rgb 1 } } } scale 2 rotate <1, 2, 3> }
light_source { Lamp translate 3 }
union { light_source { Lamp } sphere { 0, 1 } }

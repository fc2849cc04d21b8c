// What is refused by name may still be declared: as include files do.
#declare A1 = blob { threshold 0.6 sphere { 0, 1, strength 2 } component 1 1 x }
#declare A2 = lathe { linear_spline 3, <1, 0>, <1, 1>, <0, 1> }
#declare A3 = prism { linear_sweep 0, 1, 4, <0, 0>, <1, 0>, <1, 1>, <0, 0> }
#declare A4 = height_field { png "none.png" water_level 0.1 smooth }
#declare A5 = isosurface { function { x } contained_by { box { -1, 1 } }
    threshold 0 accuracy 0.01 max_gradient 4 evaluate 1, 2, 0.9 all_intersections }
#declare A6 = text { ttf "timrom.ttf" "abc" 1, 0 }
#declare A7 = superellipsoid { <0.5, 0.5> }
#declare A8 = sor { 4, <1, 0>, <1, 1>, <1, 2>, <0, 3> }
#declare A9 = sphere_sweep { b_spline 4, 0, 1, x, 1, y, 1, z, 1 tolerance 0.1 }
#declare B1 = julia_fractal { <0.1, 0.2, 0.3, 0> quaternion sqr max_iteration 8
    precision 20 slice <0, 0, 0, 1>, 0 hypercomplex pwr(1, 2) reciprocal }
#declare B2 = bicubic_patch { type 1 u_steps 3 v_steps 3 flatness 0.1
    0, x, y, z, 0, x, y, z, 0, x, y, z, 0, x, y, z }
#declare B3 = parametric { function { u } function { v } function { 0 }
    <0, 0>, <1, 1> contained_by { sphere { 0, 1 } } precompute 5 x, y, z }
#declare B4 = ovus { 1, 0.5 } #declare B5 = polynomial { 2, xyz(0, 0, 0): 1 }
#declare B6 = media { scattering { 1, 0.5 eccentricity 0.1 extinction 1 }
    absorption rgb 1 emission 1 intervals 3 samples 1, 2 density { spherical
    density_map { [0 rgb 0] [1 rgb 1] } } method 3 ratio 0.9 aa_level 4 }
#declare B7 = rainbow { direction y angle 40 width 5 distance 9 jitter 0.01
    arc_angle 90 falloff_angle 30 color_map { [0 rgb 0] } }
#declare B8 = spline { natural_spline 0, x 1, y 2, z }
#declare B9 = texture { gradient x texture_map { [0 pigment { rgb 1 }]
    [1 pigment { rgb 0 }] } }
#declare C1 = normal { average normal_map { [1 bumps 0.3] [2 wrinkles] } }
#declare C2 = pigment { image_pattern { png "none.png" use_alpha } }
#declare C3 = normal { bump_map { png "none.png" bump_size 2 use_color } slope_map {
    [0 <0, 1>] [1 <1, 1>] } no_bump_scale }
#declare C4 = pigment { quilted control0 1 control1 2 warp { black_hole x, 1
    falloff 2 strength 1 inverse repeat y turbulence 1 } warp { repeat x offset y
    flip z } warp { spherical orientation y dist_exp 1 } warp { toroidal
    major_radius 2 } warp { cubic } }
#declare C5 = pigment { function { x*y } } #declare C6 = pigment { slope y
    altitude z } #declare C7 = pigment { mandel 9 exterior 1, 1 interior 2, 1 }
#declare C8 = pigment { julia <0.1, 0.2>, 9 magnet 1 mandel 9 tiling 3 tile2 }
#declare C9 = texture { tiles { texture { } tile2 texture { } } material_map {
    png "none.png" texture { } } }
global_settings { radiosity { pretrace_start 0.1 pretrace_end 0.01 count 20
    nearest_count 5 error_bound 1 recursion_limit 2 low_error_factor 0.5
    gray_threshold 0 minimum_reuse 0.01 maximum_reuse 0.2 brightness 1
    adc_bailout 0.01 normal on media off always_sample off max_sample 1 }
    photons { count 1000 spacing 0.1 gather 20, 100 max_trace_level 3
    save_file "x" load_file "y" autostop 0 jitter 0.4 expand_thresholds 1, 2 }
    subsurface { samples 5, 5 } }

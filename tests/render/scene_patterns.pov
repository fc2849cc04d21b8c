// Forty patterns with modifiers, side by side.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -z*10 look_at 0 right x*8 up y*6 }
light_source { <-6, 8, -60> rgb 1 }
#declare CM = color_map { [0 rgb <.1,.1,.4>] [0.3 rgb <.8,.3,.2>] [0.6 rgb <.9,.9,.4>] [1 rgb <.9,1,1>] }
#declare K = 0;
#macro Put(Pg) box { <-0.48,-0.48,0>, <0.48,0.48,0.1> pigment { Pg } translate <mod(K,8)-3.5, 2.5-int(K/8), 0> finish { ambient 1 diffuse 0 } } #declare K = K + 1; #end
Put(pigment { agate agate_turb 0.5 color_map { CM } scale 0.3 })
Put(pigment { bozo color_map { CM } scale 0.2 turbulence <1,0.2,0.5> })
Put(pigment { cells color_map { CM } scale 0.2 })
Put(pigment { crackle form <-1,1,0> metric 1 offset 0.2 color_map { CM } scale 0.2 })
Put(pigment { crackle solid color_map { CM } scale 0.2 })
Put(pigment { dents color_map { CM } scale 0.2 })
Put(pigment { granite color_map { CM } scale 0.6 ramp_wave })
Put(pigment { julia <0.35,0.28>, 30 interior 1, 2 exterior 2, 0.5 color_map { CM } scale 0.3 })
Put(pigment { mandel 40 exponent 3 exterior 6, 1 color_map { CM } scale 0.3 })
Put(pigment { magnet 1 mandel 20 exterior 1, 1 color_map { CM } scale 0.2 })
Put(pigment { magnet 2 julia <0.3,0.4>, 20 color_map { CM } scale 0.2 })
Put(pigment { leopard color_map { CM } scale 0.05 cubic_wave })
Put(pigment { quilted control0 0.3 control1 0.8 color_map { CM } scale 0.3 })
Put(pigment { ripples frequency 6 phase 0.3 color_map { CM } scale 0.2 })
Put(pigment { spiral1 3 color_map { CM } scale 0.1 sine_wave })
Put(pigment { spiral2 5 color_map { CM } scale 0.1 scallop_wave })
Put(pigment { waves color_map { CM } scale 0.2 triangle_wave frequency 2 })
Put(pigment { wood color_map { CM } scale 0.15 turbulence 0.1 poly_wave 2 })
Put(pigment { wrinkles color_map { CM } scale 0.2 })
Put(pigment { planar color_map { CM } scale 0.4 rotate z*30 })
Put(pigment { boxed color_map { CM } scale 0.5 })
Put(pigment { cylindrical color_map { CM } rotate x*90 scale 0.5 })
Put(pigment { spherical color_map { CM } scale 0.5 warp { repeat x flip x } })
Put(pigment { gradient <1,2,0> color_map { CM } scale 0.3 warp { turbulence 0.5 octaves 3 } })
Put(pigment { radial frequency 5 color_map { CM } rotate x*90 warp { black_hole <0.2,0.1,0>, 0.3 strength 3 falloff 1.5 inverse } })
Put(pigment { function { sin(x*20)*cos(y*20)*0.5+0.5 } color_map { CM } })
Put(pigment { average pigment_map { [1 checker rgb 1 rgb x scale 0.2] [2 bozo color_map { CM } scale 0.1] } })
Put(pigment { pigment_pattern { bozo scale 0.2 color_map { [0 rgb 0] [1 rgb <.3,1,.5>] } } color_map { CM } })
Put(pigment { object { torus { 0.3, 0.1 rotate x*90 } rgb x, rgb z } })
Put(pigment { square scale 0.2 })
Put(pigment { triangular scale 0.2 rotate x*90 })
Put(pigment { cubic color rgb 1 color rgb x rgb y rgb z rgb 0.5 rgb x+y scale 0.3 })
Put(pigment { tiling 8 color_map { CM } scale 0.15 rotate x*90 })
Put(pigment { spotted color_map { CM } scale 0.2 noise_generator 1 })
Put(pigment { checker rgb 1 rgb 0 scale 0.05 warp { cylindrical orientation z dist_exp 1 } scale 0.5 })
Put(pigment { brick rgb x rgb y scale 0.05 warp { spherical orientation y } })
Put(pigment { hexagon rgb x rgb y rgb z scale 0.1 rotate x*90 warp { planar z, 0 } })
Put(pigment { slope { <0,0,-1>, 0, 1 } color_map { CM } })
Put(pigment { marble color_map { CM } scale 0.2 warp { toroidal orientation z major_radius 0.3 } })

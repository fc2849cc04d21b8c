// Where a whole number is wanted, what comes after the point is cut off: sizes of
// area lights, octaves, arms, steps, samples, iterations.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 3.9 number_of_waves 4.8 }
camera { location <0, 2, -7> look_at <0, .4, 0> angle 45 }
#declare N = 7;
light_source { <-4, 6, -5>, 1 area_light x*2, z*2, N/2, N/2 adaptive .9 }
#declare Map = color_map { [0 rgb <1, .3, .1>] [.5 rgb .9] [1 rgb <.1, .2, .6>] }
sphere { <-2.4, 1.2, 0>, .6 pigment { wood turbulence .5 octaves 2.8 color_map { Map } scale .4 } }
sphere { <-.8, 1.2, 0>, .6 pigment { spiral1 N/2 color_map { Map } } }
sphere { <.8, 1.2, 0>, .6 pigment { julia <.35, .3>, 7.8 interior 1.9, 2 exterior 1.6, 1 color_map { Map } translate x*.8 } }
sphere { <2.4, 1.2, 0>, .6 pigment { marble warp { turbulence .6 octaves 1.7 } color_map { Map } scale .5 } finish { reflection .5 } }
julia_fractal { <-.083, 0, -.83, -.025> quaternion sqr max_iteration 4.6 precision 20
  scale .5 translate <-2, 0, -.5> pigment { rgb <.8, .9, .6> } }
sphere { <0, 0, -.5>, .6 hollow pigment { rgbt 1 } interior { media { emission 2 method 3 intervals 1.9 samples 3.7
  density { granite scale .4 } } } }
bicubic_patch { type 1 flatness 0 u_steps 1.9 v_steps 2.8
  <0, 0, 0> <1, .9, 0> <2, 0, 0> <3, 0, 0> <0, 0, 1> <1, 1, 1> <2, -1, 1> <3, .4, 1>
  <0, 0, 2> <1, .6, 2> <2, 0, 2> <3, .5, 2> <0, 0, 3> <1, .5, 3> <2, .4, 3> <3, 0, 3>
  scale <.5, .8, .4> translate <1.2, -.4, -1> pigment { tiling 5.7 scale .2 color_map { Map } } }
plane { y, -.7 pigment { rgb .6 } normal { waves .4 scale .8 } finish { reflection .3 } }

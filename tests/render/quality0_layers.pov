// +Q0: of layered textures the deepest layer that still shows.
// compare: exact
// options: +Q0
#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0,4,-5> look_at <0,0.5,0> angle 45 }
light_source { <-5,8,-6> rgb 1 }
light_source { <5,4,-6> rgb 0.4 }
plane { y,-0.2 pigment { checker rgb 0.8 rgb 0.4 } }

sphere { 0,1.2 texture { pigment { marble turbulence 1 color_map { [0 rgb 0.9][1 rgb <0.3,0.4,0.5>] } warp { turbulence 0.3 octaves 3 } } } texture { pigment { crackle scale 0.3 color_map { [0 rgb 0][0.05 rgb 0][0.06 rgbt 1][1 rgbt 1] } } finish { specular 0.6 } } texture { pigment { bozo scale 0.5 color_map { [0.5 rgbt 1][0.6 rgbt <1,0,0,0.5>] } } } }

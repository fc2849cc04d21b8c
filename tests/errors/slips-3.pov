#version 3.7;
#macro Post(x, H) cylinder { 0, <0, H, 0>, 0.1 } #end
#macro box(H) sphere { 0, H } #end
#for (y, 0, 3) sphere { y, 1 } #end
global_settings { radiosity { distance_maximum 10 } }
sphere { 0, 1 interior { ior = 1.5 } }
text { ttf "Arial" "Hi" 1, 0 }
lathe { catmull_rom_spline 4, <0, 0>, <1, 1>, <1, 2>, <0, 3> }
lathe { linear_spline 5, <0, 0>, <1, 1>, <1, 2>, <0, 3> }

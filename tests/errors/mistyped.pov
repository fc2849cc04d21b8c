#version 3.7;
#include "colors.inc"
#include "stones.inc"
#declare Ball = sphere { 0, 1 }
#declare Brick = torus { 1, .3 }
#declare Jade = pigment { rgb y }
sphere { <0, 2, -3
    1 }
sphere { <0.4, 0.4, 0.4, 0, Ball), 1 }
object { brick }
#declare Textures = array(8);
#for (I, 0, 7) #declare Textures[I] = texture { pigment { rgb 1 } } #end
#for (t, 0, 7) #end
#declare Path = spline { natural 0, x, 1, y };
sphere { 0, 1 pigment { checker Jade White } }
sphere { 0, 1 texture { hexagon T_Stone1 T_Stone2 T_Stone3 } }
text { ttf "timrom.ttf", Balls, .1, 0 }
object { Cylinder_Z }
#while (!eof(File)) #end
lathe { linear_spline 3, <0, 0, 0>, <1, 0, 0>, <1, 1, 0> }
light_source { y, rgb 1 area_light x, z, 3 }
light_source { y, rgb 1 spotlight look_at 0 }
#declare Table = array[2, 3];
#declare Way = spline { linear_spline <0, 0, 0>, <1, 0, 0> };
mesh2 {
    vertex_vectors { 3, x, y, z }
    texture_list { 1, texture { pigment { rgb 1 } } texture { pigment { rgb x } } }
    face_indices { 1, <0, 1, 2>, 0 }
}
box { 0, 1 pigment { image_map { png "../render/parts/dot.png" interpolate bilinear } } }

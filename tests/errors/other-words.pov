sphere { 0, 1 pigment { checkerboard rgb 1 rgb 0 } }
sphere { 0, 1 pigment { stripes rgb 1 rgb 0 } }
sphere { 0, 1 pigment { wood color_map { [0 1 rgb 1] } } }
sphere { 0, 1 halo { emitting } }
sphere { 0, 1 visible off }
sphere { 0, 1 clip_by { plane { y, 0 } } }
sphere { <1>, 1 }
prism { <0, 0> <1, 0> <1, 1> <0, 0> }
fog { distance 10 fog_height 3 }
text { ttf "timrom.ttf" "A" 1, 0 center }
light_source { 0 rgb 1 area_light x, z, 4, 4 circle }
sphere { <1 -1 0>, 1 }
#until (1) #end

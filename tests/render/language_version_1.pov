// Scenes of version 1: no arithmetic outside parentheses, and what pigments,
// normals and finishes are made of stands in a texture by itself.
// compare: exact
#version 1.0
max_trace_level 4
#declare Rose = color red 0.9 green 0.4 blue 0.5
#declare Veined = texture {
    0
    marble turbulence 0.6
    color_map { [0 0.6 Rose color red 1] [0.6 1 color green 1 color blue 1] }
    scale 0.4 waves 0.4 frequency 4 phase 0.2
}
camera { location <0 3 -7> direction <0 0 1.6> look_at <0 -0.2 0> }
object { light_source { <-5 9 -8> color red 1 green 1 blue 1 } }
fog { color blue 0.5 60 }
object {
    plane { <0 1 0> -1 }
    texture { checker color Rose color red 1 green 1 blue 1 scale 0.7 reflection 0.2 }
    color Rose
}
sphere { <-2 0 (1-2)> 1 texture { Veined phong 0.8 phong_size 20 } }
sphere { <0 0 0> 1
    texture { Rose alpha 0.3 bumps 0.5 specular 0.5 }
    texture { wood color_map { [0 1 color red 1 alpha 1 color green 0.6] } scale 0.3 }
}
composite {
    object { box { <1.2 -1 -1> <2.4 0.2 0.6> } texture { Rose ambient 0.4 wrinkles 0.5 scale 0.2 } }
    rotate <0 -12 0>
}

// Texture maps and blocks of textures whose entries mirror, are clear, have
// bumps or a shine of their own: each picture has many blends of two.
// compare: exact
// options: -A
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -8> look_at 0 angle 45 }
light_source { <-6, 8, -9> rgb 0.8 }
light_source { <7, 3, -9> rgb 0.4 }
background { rgb <0.3, 0.4, 0.5> }

plane { y, -1.2 pigment { checker rgb 1 rgb 0.3 } }

sphere {
    <-2.4, 0, 0>, 1.1
    texture {
        marble
        turbulence 0.5
        texture_map {
            [0 pigment { rgbf <1, 0.7, 0.3, 0.6> }
               finish { reflection 0.3 phong 1 }
               normal { bumps 0.4 scale 0.1 }]
            [0.5 pigment { granite }
               finish { reflection { 0.1, 0.6 fresnel on } conserve_energy }
               normal { ripples 0.5 scale 0.3 }]
            [1 pigment { wrinkles scale 0.2
                 color_map { [0 rgbt <1, 1, 1, 1>] [1 rgb <0, 0, 1>] } }
               finish { specular 0.8 metallic }]
        }
        rotate 30 * z
        scale 0.6
    }
    interior { ior 1.3 }
}

box {
    -0.9, 0.9
    texture {
        brick
        texture { pigment { rgb 0.7 } normal { granite 0.2 }
            finish { reflection 0.2 } }
        texture { pigment { rgbt <0.2, 0.9, 0.2, 0.7> } finish { phong 1 } }
        scale 0.08
    }
    rotate 40 * y
}

#declare Stained =
    texture { pigment { rgb <0.2, 0.5, 0.2> } }
    texture { pigment { bozo color_map { [0.3 rgbt 1] [0.8 rgb 1] } scale 0.2 }
        finish { reflection 0.1 } }

cylinder {
    <2.4, -1.1, 0>, <2.4, 1.1, 0>, 1
    texture {
        gradient y
        texture_map {
            [0.3 Stained]
            [0.5 pigment { rgbt <0, 1, 0, 0.8> } normal { waves 0.4 scale 0.3 }]
            [0.8 pigment { rgb <1, 0, 0> }
               finish { irid { 0.3 thickness 0.4 turbulence 0.5 } }]
        }
        translate 0.3 * y
    }
}

// height_field: grey of 8 and 16 bits, a palette, colours; smooth, under water,
// cut, as a part of solids.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5.5, -6> right 4/3*x look_at <0, 0, .3> angle 42 }
light_source { <-8, 9, -4>, rgb 1 }
background { rgb <.25, .3, .4> }
#default { pigment { rgb <.8, .7, .5> } }
height_field { png "parts/heights8.png" translate <-1.6, 0, 1> }
height_field { png "parts/heights16.png" smooth scale <1, .6, 1>
    translate <-.5, 0, 1> pigment { gradient y scale .1 } }
height_field { png "parts/heights_palette.png" smooth scale <1, .4, 1>
    translate <.6, 0, 1> finish { phong .6 phong_size 30 } }
height_field { png "parts/heights_colour.png" water_level .5
    translate <-1.6, -.2, -.3> }
height_field { png "parts/heights8.png" smooth water_level .4 hierarchy off
    scale <1, .7, 1> translate <-.5, 0, -.3> pigment { checker scale .1 } }
difference {
    box { <.01, -.3, .01>, <.99, .3, .99> }
    height_field { png "parts/heights16.png" translate -.2*y }
    translate <.6, 0, -.3>
}
intersection {
    sphere { <.5, .3, .5>, .48 }
    height_field { png "parts/heights16.png" smooth }
    translate <-1.6, 0, -1.6>
}
intersection {
    box { <-.1, -.3, -.1>, <1.1, .5, 1.1> }
    height_field { png "parts/heights16.png" }
    translate <-.5, 0, -1.6>
}
height_field { png "parts/heights8.png" smooth
    clipped_by { cylinder { -y, y, .5 translate .5*(x + z) } }
    translate <.6, 0, -1.6> }

// Up to version 3.1 layers above the bottom one filter as if they transmitted;
// in their shadows, too.
// compare: exact
#version 3.1;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -7> look_at <0, 1, 0> angle 45 }
light_source { <-4, 7, -8>, rgb 1 }
background { rgb <.2, .25, .2> }
plane { y, 0 pigment { rgb .9 } }
#declare Bands = texture {
    pigment { rgbf <.9, .8, .7, .4> }
} texture {
    pigment { gradient y color_map { [0 rgbf <1, 0, 0, 1>] [1 rgbf <0, .6, 0, .2>] } scale .5 }
}
sphere { <-1.7, 1, 0>, .8 texture { Bands } }
box { <-.6, .2, 0>, <.6, 1.6, .2>
    texture { pigment { rgb <.9, .8, .3> } }
    texture { pigment { checker rgbf <1, .5, .2, .5> rgbt <0, 0, 1, .6> scale .3 } } }
sphere { <1.7, 1, 0>, .8
    texture { pigment { rgbf <.9, .8, .7, .4> } }
    texture { pigment { image_map { png "parts/heights_palette.png" filter 0 .3 filter all .6 } } }
    texture { pigment { bozo pigment_map { [.4 rgbf <1, .6, .6, .8>] [.6 wood color_map { [0 rgbf .9] [1 rgb x] }] } scale .3 } } }

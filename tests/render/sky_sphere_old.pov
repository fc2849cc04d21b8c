// sky_sphere before version 3.7: filters of layers in front of others don't
// colour these, only the background.
// compare: exact
#version 3.6;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> right 4/3*x look_at <0, 1, 0> angle 60 }
light_source { <-4, 8, -6>, rgb 1 }
background { rgb <.2, .6, .8> }
sky_sphere {
    pigment { gradient y color_map {
        [0 rgbft <.5, 1, .2, .6, .2>] [1 rgbf <.9, .8, .2, .5>] } }
    pigment { radial frequency 2 color_map {
        [0 rgbft <1, .3, .7, .4, .3>] [.5 rgb <.2, .3, .9>] [1 rgbf 1] } }
    pigment { gradient x triangle_wave color_map {
        [0 rgbft <.1, .3, .9, .4, .5>] [1 rgbf <1, .7, .3, .9>] } }
}
sphere { <0, .9, 0>, .9 pigment { rgb .1 } finish { reflection .8 } }

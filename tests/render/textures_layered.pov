// Layered textures: a transparent layer over an opaque one, three layers,
// layers with their own finish and transform.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -7> right 4/3*x look_at <0, 0, 0> angle 40 }
light_source { <-4, 6, -8>, rgb 1 }
background { rgb <.3, .4, .5> }
#declare Base = texture { pigment { rgb <.9, .8, .5> } finish { phong .4 } }
#declare Stripes = texture { pigment { gradient y color_map {
    [0 rgbt <.7, .1, .1, 0>] [.4 rgbt <.7, .1, .1, 0>]
    [.6 rgbt <1, 1, 1, 1>] [1 rgbt <1, 1, 1, 1>] } scale .3 translate .04 } }
#declare Spots = texture { pigment { leopard color_map {
    [.4 rgbf <1, 1, 1, 1>] [.6 rgbf <.1, .2, .8, .3>] } scale .05 } }
sphere { <-1.8, 0, 0>, .9 texture { Base } texture { Stripes } }
box { -.65, .65 texture { Base } texture { Stripes rotate 45*z }
    texture { Spots } rotate <-20, 30, 0> }
#declare Both = texture { Stripes } texture { Spots scale 2 };
sphere { <1.8, 0, 0>, .9 texture { Both } }

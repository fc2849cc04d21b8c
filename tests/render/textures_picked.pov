// texture_map and textures for blocks: blended paint, finish and bumps, layers
// in them, transparent ones, moved inside and outside, one in another.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <0, 3, -8> right 4/3*x look_at <0, .8, 0> angle 45 }
light_source { <-4, 7, -8>, rgb 1 }
background { rgb <.2, .25, .2> }
#declare Red = texture { pigment { rgb <.9, .2, .1> } finish { phong .9 } }
#declare Stripes = texture { pigment { gradient y color_map { [.5 rgb 1]
    [.5 rgb <.1, .2, .6>] } scale .2 } normal { leopard .8 scale .05 } }
sphere { <-2.3, 1, 1>, 1 texture { gradient x texture_map { [.2 Red]
    [.6 Stripes rotate 40*z] [.8 pigment { rgb <.2, .8, .3> }
    finish { reflection .3 ambient .2 }] } scale 1.4 rotate 20*y } }
box { <-.9, 0, .2>, <.9, 1.7, 2> texture { checker texture { Red }
    texture { Stripes } scale .5 rotate 30*y } }
sphere { <2.3, 1, 1>, 1 texture { spherical texture_map { [0 Red]
    [1 checker texture { Stripes } texture { pigment { rgb .8 } } scale .3] }
    frequency 2 scale 1.5 translate <2, 1, .5> } }
sphere { <-1.6, .7, -1.4>, .7 texture { onion texture_map {
    [.3 pigment { rgbf <.5, .9, .6, .8> }] [.7 pigment { rgbt <.8, .3, .3, .4> }] }
    scale .7 translate <-1.6, .7, -1> } }
box { -.6, .6 texture { brick texture { pigment { rgb .3 } },
    texture { Stripes scale 2 } scale .1 } rotate -25*y translate <0, .6, -1.4> }
#declare Choice = texture { radial texture_map { [0 Red] [.5 Stripes] [1 Red] }
    frequency 3 sine_wave }
sphere { 0, .7 texture { Choice rotate 90*x scale .8 } translate <1.7, .7, -1.4> }
plane { y, 0 texture { hexagon texture { pigment { rgb .8 } }
    texture { pigment { rgb .5 } } texture { pigment { rgb .6 }
    finish { reflection .4 } } } }

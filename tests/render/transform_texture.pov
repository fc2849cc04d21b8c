// Textures move with the object when given before the transform, and stay
// in the world when given after it; texture transforms of their own.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -8> right 4/3*x look_at <0, .4, 0> angle 45 }
light_source { <-5, 8, -9>, rgb 1 }
background { rgb .2 }
#declare Bars = pigment { gradient x color_map {
    [0 rgb <.9, .3, .2>] [.5 rgb <.9, .3, .2>] [.5 rgb .9] [1 rgb .9] } scale .4 translate .13*x }
box { -.8, .8 pigment { Bars } rotate <20, 30, 40> translate <-2.4, 1.4, 0> }
box { -.8, .8 rotate <20, 30, 40> pigment { Bars } translate <0, 1.4, 0> }
box { -.8, .8 rotate <20, 30, 40> translate <2.4, 1.4, 0> pigment { Bars } }
sphere { 0, .8 pigment { Bars rotate 45*z } scale <1, .5, 1>
    translate <-2.4, -.6, 0> }
sphere { 0, .8 texture { pigment { Bars scale 2 } rotate 90*z translate .1 }
    scale <1, .5, 1> translate <0, -.6, 0> }
sphere { 0, .8 texture { pigment { Bars matrix
    <1, .5, 0, 0, 1, 0, 0, 0, 1, .1, 0, 0> } } scale <1, .5, 1>
    translate <2.4, -.6, 0> }

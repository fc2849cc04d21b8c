// Black holes in cells: moved at random, larger than their cells.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <.5, .5, -5> look_at <.5, .5, 0> up y * 6 right x * 8 }
#default { finish { ambient 0 diffuse 0 emission 1 } }
box { <-4, -3, 0>, <.5, 4, 1>
    pigment { checker rgb 1 rgb x scale .2
        warp { black_hole <.5, .5, .5>, .4 repeat <1, 1, 1> turbulence <.2, .1, .3> } }
    translate <0, .1, -.4> }
box { <.5, -3, 0>, <5, 4, 1>
    pigment { checker rgb 1 rgb y scale .2
        warp { black_hole <.2, .4, .1>, .8 repeat <.7, 1.3, 9>
            turbulence <.3, .2, .1> falloff 1.5 strength 1.2 } }
    translate <0, .1, -.4> }

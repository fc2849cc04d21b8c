// density_file: of one and two bytes, with and without interpolation; what is
// outside of it.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -5> right 4*x up 3*y }
light_source { <-5, 8, -16>, 1 }
#default { finish { ambient .5 diffuse .5 } }
#macro Card(P) box { <0, 0, .3>, <.95, .95, 1> pigment { P
    color_map { [0 rgb 0] [.5 rgb <1, .5, 0>] [1 rgb 1] } } } #end
object { Card(pigment { density_file df3 "parts/numbers8.df3" })
    translate <-1.9, .1, 0> }
object { Card(pigment { density_file df3 "parts/numbers8.df3" interpolate 1 })
    translate <-.9, .1, 0> }
object { Card(pigment { density_file df3 "parts/numbers16.df3" interpolate 1
    frequency 2 }) translate <.1, .1, 0> }
object { Card(pigment { density_file df3 "parts/numbers8.df3" interpolate 1
    scale .5 rotate 20*z translate .2 }) translate <1.1, .1, 0> }
sphere { <-1.3, -.7, 0>, .6 pigment { density_file df3 "parts/numbers16.df3"
    turbulence .3 scale 1.2 translate -.6 translate <-1.3, -.7, 0> } }
object { Card(pigment { density_file df3 "parts/numbers8.df3" interpolate 2 })
    translate <-.5, -1.2, 0> }
object { Card(pigment { density_file df3 "parts/numbers16.df3" interpolate 3
    rotate 20*z }) translate <.6, -1.2, 0> }

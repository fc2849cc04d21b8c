// The sides of boxes as large as the picture on them: rounding doesn't decide
// which of its edges they show.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -5> look_at 0 angle 50 }
light_source { <0, 3, -10>, rgb 1 parallel point_at 0 }
background { rgb <.8, .5, .8> }
#default { finish { ambient .3 diffuse .7 } }
#macro Sides(At)
    box { -.5, .5
        pigment { image_map { png "parts/flag.png" } translate <-.5, -.5, 0> }
        scale 1.3 rotate <10, 35, 5> translate At }
#end
Sides(<-1.1, .8, 0>)
object { Sides(0) rotate <20, 90, 0> translate <1.1, .8, 0> }
object { Sides(0) rotate 50*y translate <-1.1, -1, 0> }
cylinder { -.5*y, .5*y, .5
    pigment { image_map { png "parts/flag.png" map_type 2 } translate -.5*y }
    scale 1.3 rotate <-30, 20, 10> translate <1.1, -1, 0> }

// pigment_map: patterns inside a pattern, blended, one of them declared.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -5> right 4*x up 3*y }
light_source { <0, 0, -100>, rgb 1 parallel point_at 0 }
#default { finish { ambient 0 diffuse 1 } }
#declare Squares = pigment {
    checker rgb <.9, .3, .2>, rgb <.9, .9, .4> scale .23 translate <.05, .03, .02> }
box { <-2, .05, 0>, <2, 1.5, .1>
    pigment { gradient x pigment_map {
        [0 Squares scale .25]
        [.4 rgb <.2, .5, .9>]
        [.6 gradient y color_map { [0 rgb 0] [1 rgb 1] } scale .08]
        [.6 Squares scale .5]
        [1 rgb <.1, .6, .2>] }
    scale 4 translate -2*x } }
box { <-2, -1.5, 0>, <2, -.05, .1>
    pigment { checker
        pigment { Squares rotate 45*z }
        pigment { gradient x color_map { [0 rgb <.1, .2, .6>] [1 rgb .9] } scale .3 }
        scale .9 translate <.4, .2, .1> } }

// color_map: steps, gaps at both ends, filter inside, colour_map, and the old
// entries with two positions and two colours.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -5> right 4*x up 3*y }
light_source { <0, 0, -100>, rgb 1 parallel point_at 0 }
background { rgb <.2, .3, .5> }
#default { finish { ambient 0 diffuse 1 } }
#macro Strip(Row, P)
    box { <-2, -.36, 0>, <2, .36, .1>
        pigment { P scale 4 translate -2*x } translate (1.1 - .74*Row)*y }
#end
Strip(0, pigment { gradient x color_map {
    [0 rgb <1, 0, 0>] [.3 rgb <1, 1, 0>] [.3 rgb <0, .5, 0>] [1 rgb <0, 0, 1>] } })
Strip(1, pigment { gradient x colour_map {
    [.25 rgb <.9, .2, .6>] [.4 rgb .9] [.8 rgb <.1, .6, .7>] } })
Strip(2, pigment { gradient x color_map {
    [0 .33 color rgb <.8, .7, .1> color rgb <.2, .6, .2>]
    [.33 .66 color rgb 0 color rgb 1]
    [.66 1.01 color red .9 color blue .8] } })
Strip(3, pigment { gradient x color_map {
    [0 rgbt <.9, .2, .1, 0>] [.5 rgbt <.1, .9, .2, 1>] [1 rgbf <.9, .9, .1, .5>] } })

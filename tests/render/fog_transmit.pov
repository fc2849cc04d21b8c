// Several fogs at once, with filter and with transmit, before a far wall.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -10> right 4/3*x look_at <0, 1, 0> angle 50 }
light_source { <-4, 8, -6>, rgb 1.2 }
fog { fog_type 1 distance 15 rgbt <.9, .6, .4, .3> }
fog { distance 25 rgbf <.3, .5, .9, .5> }
plane { z, 30 pigment { gradient y color_map {
    [0 rgb <.9, .9, .4>] [1 rgb <.2, .3, .7>] } scale 12 translate .1 } }
sphere { <-2.5, 1, -3>, 1 pigment { rgb <.9, .3, .3> } }
sphere { <1.2, 1, 4>, 1 pigment { rgb <.3, .9, .3> } }
sphere { <5, 1, 12>, 1 pigment { rgb <.3, .3, .9> } }
plane { y, 0 pigment { checker rgb .8, rgb .5 scale 2 translate .3 } }

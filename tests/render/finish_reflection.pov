// reflection: a number, a colour, minimum and maximum, falloff, exponent,
// metallic with and without a value; balls in a room with checkered walls.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
camera { location <0, 1.5, -8> right 4/3*x look_at <0, 0, 0> angle 38 }
light_source { <-4, 5, -8>, rgb .9 }
plane { y, -1.7 pigment { checker rgb <.9, .4, .3>, rgb .9 translate .3 } }
plane { z, 9 pigment { checker rgb <.3, .5, .9>, rgb .9 translate .4 scale 2 } }
plane { z, -12 pigment { gradient y color_map {
    [0 rgb <.2, .7, .3>] [1 rgb <.9, .9, .3>] } scale 3 translate .1 } }
plane { y, 12 pigment { rgb <.6, .8, 1> } finish { ambient .7 diffuse 0 } }
#default { finish { ambient .05 diffuse .2 } }
#macro Ball(Column, Row, F)
    sphere { 0, .72 pigment { rgb <.9, .6, .2> }
        finish { F }
        translate <1.65*Column - 2.48, .8 - 1.6*Row, 0> }
#end
Ball(0, 0, finish { reflection .6 })
Ball(1, 0, finish { reflection rgb <.2, .8, .5> })
Ball(2, 0, finish { reflection { .05, .9 } })
Ball(3, 0, finish { reflection { rgb <.5, 0, 0>, rgb 1 falloff 3 } })
Ball(0, 1, finish { reflection { .8 metallic } })
Ball(1, 1, finish { reflection { .3, .9 falloff 2 metallic .6 } })
Ball(2, 1, finish { reflection { .6 exponent 1.8 } })
Ball(3, 1, finish { reflection { .6 exponent .5 } phong .5 })

// Triangles, flat and smooth: a fan around an edge, with normals of no
// particular length, lit from both sides.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -7> right 4/3*x look_at <0, .9, 0> angle 45 }
light_source { <-5, 7, -8>, rgb 1 }
light_source { <5, 3, 6>, rgb <.4, .4, .6> }
background { rgb .12 }
triangle { <-2.6, 0, 0>, <-.6, 0, -.5>, <-1.8, 2, .3>
    pigment { rgb <.9, .6, .2> } }
triangle { <-2.9, .1, .9>, <-1.8, 2.1, .6>, <-.3, 0, .9>
    pigment { rgb <.7, .3, .3> } }
smooth_triangle {
    <.2, 0, 0>, <-.7, .1, -1>, <2.2, 0, 0>, <.8, .2, -.7>,
    <1.2, 2, .3>, <.1, 3, -2> pigment { rgb <.3, .7, .9> }
    finish { phong .5 phong_size 20 } }
smooth_triangle {
    <2.2, 0, 0>, <.8, .2, -.7>, <1.2, 2, .3>, <.1, 3, -2>,
    <2.8, 1.9, .9>, <.9, .5, -.1> pigment { rgb <.4, .9, .5> }
    finish { phong .5 phong_size 20 } }
plane { y, -.2 pigment { rgb .5 } }

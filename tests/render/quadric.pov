// quadric: an ellipsoid, a hyperboloid and a paraboloid, cut by boxes.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -8> right 4/3*x look_at <0, .8, 0> angle 45 }
light_source { <-5, 8, -7>, rgb 1 }
background { rgb <.25, .2, .25> }
quadric { <1, 2, 3>, <.3, 0, .4>, <0, 0, 0>, -1 translate <-2.5, .8, 0>
    pigment { rgb <.9, .5, .2> } }
intersection {
    quadric { <1, -.6, 1>, <0, 0, 0>, <0, 0, 0>, -.25
        pigment { rgb <.3, .8, .6> } }
    box { <-2, -1, -2>, <2, .9, 2> pigment { rgb <.9, .9, .4> } }
    translate <0, 1.01, .3>
}
quadric { <1, 0, 1>, <0, 0, 0>, <0, -.6, 0>, 0
    clipped_by { box { <-2, -1, -2>, <2, 1.7, 2> } }
    translate <2.3, .01, 0> pigment { rgb <.5, .5, .95> } }
plane { y, -.01 pigment { rgb .6 } }

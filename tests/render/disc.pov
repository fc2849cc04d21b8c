// Discs: whole, with a hole, seen from behind and from the edge.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -8> right 4/3*x look_at <0, .9, 0> angle 42 }
light_source { <-4, 8, -8>, rgb 1 }
background { rgb <.25, .2, .2> }
disc { <-2, 1, 0>, <.3, .4, -1>, 1 pigment { rgb <.9, .5, .2> } }
disc { <.2, 1.1, 0>, <-.2, .5, 2>, 1.1, .5 pigment { rgb <.3, .8, .6> } }
disc { <0, 0, 0>, y, 1, .2 scale <1.2, 1, .5> rotate <-40, 20, 0>
    translate <2.2, .9, 0> pigment { rgb <.6, .5, .9> } }
disc { <0, 0, 0>, y, 5 pigment { rgb .7 } }

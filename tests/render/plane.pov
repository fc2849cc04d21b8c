// Planes: a floor, walls not along the axes, a normal that is not of length 1
// (the distance counts along the normalised normal).
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> right 4/3*x look_at <0, 1.2, 0> angle 65 }
light_source { <-2, 4, -5>, rgb 1.4 }
plane { y, 0 pigment { checker rgb .9, rgb <.3, .4, .6> } }
plane { <-1, 0, -2>, -2 pigment { rgb <.8, .6, .4> } }
plane { z, 0 rotate -55*y translate <-2, 0, 3> pigment { rgb <.5, .8, .5> } }
plane { <0, 3, 0>, 4.5 inverse
    pigment { checker rgb <.9, .5, .5>, rgb .95 scale 2 translate .31 } }

// Before version 3.7 surfaces keep their ambient beside radiosity, in a closed
// room as well.
// claims: rays path bounced skeleton
//
// ambient_light <2, 1, .5>: the box has <.5, .4, .8> * (.1 * ambient_light).
// No light of the lamp gets in, and no wall sends back any.
#version 3.6;
global_settings { assumed_gamma 1 ambient_light rgb <2, 1, .5> radiosity { } }
camera { orthographic location <-.05, .05, -10> right 6.4*x up 4.8*y }
box { -20, 20 hollow pigment { rgb 0 } finish { ambient 0 diffuse 0 } }
light_source { <2, 3, -90> rgb 1 }
box { <-3, -2, 0>, <-.5, 2, 1> pigment { rgb <.5, .4, .8> }
    finish { ambient .1 diffuse .6 } }

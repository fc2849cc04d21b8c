// ambient and emission without any lamp.
// claims: rays
//
// ambient_light <2, 1, .5> multiplies ambient and not emission:
// left: pigment <.5, .4, .8> * (.1 * ambient_light) = <.1, .04, .04>;
// right: <.5, .4, .8> * (.1 * ambient_light + .3) = <.25, .16, .28>.
// The background is taken as it is.
#version 3.7;
global_settings { assumed_gamma 1 ambient_light rgb <2, 1, .5> }
camera { orthographic location <-.05, .05, -10> right 6.4*x up 4.8*y }
background { rgb <.7, .02, 1.5> }
box { <-3, -2, 0>, <-.5, 2, 1> pigment { rgb <.5, .4, .8> }
    finish { ambient .1 } }
box { <.5, -2, 0>, <3, 2, 1> pigment { rgb <.5, .4, .8> }
    finish { ambient .1 emission .3 } }

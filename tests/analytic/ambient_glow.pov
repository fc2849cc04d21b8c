// What reflects nothing glows by its ambient, as old scenes write it.
// claims: rays mesh soft skeleton path
//
// ambient_light <2, 1, .5> multiplies ambient and not emission: pigment
// <.5, .4, .8> * (.3 * ambient_light + .1) = <.35, .16, .2>.
#version 3.7;
global_settings { assumed_gamma 1 ambient_light rgb <2, 1, .5> }
camera { orthographic location <-.05, .05, -10> right 6.4*x up 4.8*y }
box { <-3, -2, 0>, <3, 2, 1> pigment { rgb <.5, .4, .8> }
    finish { ambient .3 diffuse 0 emission .1 } }

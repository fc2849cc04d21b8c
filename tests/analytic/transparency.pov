// Panes before a glowing wall: each multiplies by filter * pigment + transmit,
// a solid pane twice; its own light is weakened by its opacity.
// claims: rays mesh soft
//
// The wall glows <.8, .6, .4>. Left: a disc, rgbft <.5, 1, 0, .5, .25>: factor
// <.5, .75, .25>, so <.4, .45, .1>, plus its own emission .2 * opacity .25 *
// pigment = <.025, .05, 0>: <.425, .5, .1>. Right: a box of the same without
// emission: factor squared: <.2, .3375, .025>. The middle: the wall itself.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <-.05, .05, -10> right 6.4*x up 4.8*y }
plane { -z, -3 pigment { rgb <.8, .6, .4> }
    finish { ambient 0 diffuse 0 emission 1 } }
disc { <-1.6, 0, 0>, z, 1 pigment { rgbft <.5, 1, 0, .5, .25> }
    finish { ambient 0 diffuse 0 emission .2 } }
box { <.6, -1, 0>, <2.6, 1, 1> pigment { rgbft <.5, 1, 0, .5, .25> }
    finish { ambient 0 diffuse 0 } }

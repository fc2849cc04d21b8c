// A room that is closed on all sides, with its only lamp outside: nothing but
// the ambient term would be seen, so nothing stands before it.
// claims: rays mesh skeleton
//
// Pigment <.5, .4, .8> * .3 = <.15, .12, .24>.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <-.05, .05, -5> right 6.4*x up 4.8*y }
light_source { <0, 0, -40> rgb 1 }
box { <-9, -9, -9>, <9, 9, 9> inverse pigment { rgb <.5, .4, .8> }
    finish { ambient .3 } }

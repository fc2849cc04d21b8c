// no_bump_scale: bumps as high as before they are scaled, unevenly too.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> look_at 0 angle 40 }
light_source { <-5, 8, -6>, 1 }
#default { pigment { rgb <.9, .6, .3> } finish { ambient .1 } }
sphere { <-1, .9, 0>, .9 normal { bumps .4 scale <.2, 1, .5> no_bump_scale } }
sphere { <1, .9, 0>, .9 texture { normal { gradient x .3 no_bump_scale } scale .3 } }
sphere { <-1, -.9, 0>, .9 texture { normal { wrinkles .4 } scale 2 no_bump_scale } }
sphere { <1, -.9, 0>, .9 normal { bumps .4 scale .3 } }
sphere { <-.7, 0, 0>, .3 normal { bumps .4 scale .3 no_bump_scale } scale <3, .8, 1> translate <2.1, 0, -.6> }
sphere { <2.6, 2, 2>, .9 texture { gradient y texture_map {
    [0 normal { bumps .4 no_bump_scale }] [1 normal { bumps .4 scale .3 }] } scale .4 } }

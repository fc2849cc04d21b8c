// radiosity: a room with coloured walls and a lamp, a window to the sky, a ball
// of bumps, and glow; with recursion_limit and brightness.
// compare: noise
#version 3.7;
global_settings { assumed_gamma 1
    radiosity { count 200 error_bound .25 nearest_count 8 pretrace_start .08
        pretrace_end .02 recursion_limit 2 brightness 1.3 } }
camera { location <0, 1.5, -3.4> right 4/3*x look_at <0, 1.4, 0> angle 62 }
background { rgb <.5, .7, 1> }
light_source { <.6, 2.6, -1>, rgb .35 }
#default { finish { ambient .4 diffuse .7 } }
box { <-2, -.1, -4>, <2, 0, 2> pigment { rgb .8 } }
box { <-2, 3, -4>, <2, 3.1, 2> pigment { rgb .8 } }
box { <-2.1, 0, -4>, <-2, 3, 2> pigment { rgb <.8, .2, .1> } }
difference {
    box { <2, 0, -4>, <2.1, 3, 2> } box { <1, 1, -1>, <3, 2.2, 1> }
    pigment { rgb <.2, .7, .2> } }
box { <-2, 0, 2>, <2, 3, 2.1> pigment { rgb .8 } }
sphere { <-.8, .6, .3>, .6 pigment { rgb .9 } normal { bumps .3 scale .1 } }
box { <.3, 0, 0>, <1.1, 1.2, .8> pigment { rgb .7 } }
sphere { <1.4, .25, -.8>, .25 pigment { rgb <1, .6, .2> } finish { emission .9 diffuse 0 } }

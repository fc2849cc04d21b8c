// +UA: alpha, straight in PNG; the background is transparent.
// compare: exact
// options: +UA
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -8> right 4/3*x look_at <0, .8, 0> angle 42 }
light_source { <-5, 9, -6>, rgb 1 area_light 2*x, 2*z, 3, 3 }
sphere { <0, 2.6, 1>, .5 pigment { rgbt <.9, .2, .2, .6> } }
sphere { <-1.8, .9, 0>, .9 pigment { rgb <.9, .4, .2> quick_color rgb <.2, .9, .4> }
    finish { phong .7 } }
box { <-.6, 0, 0>, <.6, 1.2, 1> pigment { checker rgb <.9, .9, .3>, rgb <.3, .4, .8>
    scale .31 translate .1 } }
sphere { <1.9, .9, 0>, .9 pigment { rgbf <.9, .9, .9, .7> }
    finish { reflection .3 } interior { ior 1.3 } }


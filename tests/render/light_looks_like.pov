// looks_like shows the light and casts no shadow of it; the shape follows the
// light's transforms; media_interaction and media_attenuation are accepted.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4, -8> right 4/3*x look_at <0, .8, 0> angle 42 }
background { rgb .1 }
#declare Bulb = union {
    sphere { 0, .25 pigment { rgb <1, .9, .6> } }
    cylinder { 0, .6*y, .08 pigment { rgb <.5, .5, .6> } }
    finish { ambient .8 diffuse .2 } }
light_source { <-1.8, 1.8, 0>, rgb <.9, .8, .6> looks_like { Bulb } }
light_source { 0, rgb <.4, .6, .9> looks_like { object { Bulb scale 1.5 } }
    rotate 30*z translate <1.8, 1.5, -.6>
    media_interaction off media_attenuation off }
sphere { <0, .5, 0>, .5 pigment { rgb .9 } }
plane { y, 0 pigment { rgb .8 } }

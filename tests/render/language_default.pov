// #default for pigment, finish and normal, changed on the way; declared
// textures made before a change keep the old one.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -8> right 4/3*x look_at <0, .6, 0> angle 42 }
light_source { <-5, 9, -6>, rgb 1 }
background { rgb <.3, .3, .4> }
#declare Old = texture { pigment { rgb <.9, .8, .2> } }
sphere { <-3, .6, 0>, .6 }
#default { pigment { rgb <.9, .3, .2> } finish { ambient .3 phong .8 } }
sphere { <-1.5, .6, 0>, .6 }
sphere { <0, .6, 0>, .6 texture { Old } }
#default { texture { pigment { rgb <.3, .8, .4> }
    finish { ambient 0 diffuse .9 brilliance 2 } } }
sphere { <1.5, .6, 0>, .6 }
sphere { <3, .6, 0>, .6 pigment { rgb <.5, .5, .9> } }
union {
    box { <-1, 0, -2>, <0, .5, -1.5> }
    box { <.2, 0, -2>, <1.2, .5, -1.5> finish { ambient .4 } }
    box { <1.4, 0, -2>, <2.4, .5, -1.5> pigment { rgb <.9, .5, .8> } }
    texture { Old }
}
plane { y, -.01 pigment { rgb .6 } }

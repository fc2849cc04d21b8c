// translate, rotate, scale in their order; matrix; transform{} declared,
// combined and inverted; a negative scale.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 6, -9> right 4/3*x look_at <0, .4, 0> angle 42 }
light_source { <-6, 9, -6>, rgb 1 }
background { rgb <.25, .25, .3> }
#declare Flag = union {
    cylinder { 0, 1.2*y, .08 pigment { rgb .9 } }
    box { <0, .6, -.04>, <.9, 1.2, .04> pigment { rgb <.9, .3, .2> } }
    sphere { 1.2*y, .15 pigment { rgb <.9, .8, .2> } }
}
#declare Turn = transform { rotate 60*y translate <1, 0, .5> }
#declare Lean = transform {
    matrix <1, 0, 0,  .4, 1, .2,  0, 0, 1,  0, 0, 0> }
object { Flag translate <-3.5, 0, 0> rotate 25*y }
object { Flag rotate 25*y translate <-2.3, 0, 1.4> }
object { Flag scale <1.5, .7, 1> rotate <0, 0, 20> translate <-1.5, 0, -1> }
object { Flag transform { Turn } }
object { Flag transform { Turn inverse } }
object { Flag transform { Lean } translate <1.3, 0, -1.3> }
object { Flag scale <-1, 1, 1> transform { transform { Lean } translate <2, 0, 0> }
    translate <1, 0, 1> }
object { Flag
    matrix <.8, 0, .6,  0, 1.2, 0,  -.6, 0, .8,  3, 0, -.8> }
plane { y, -.05 pigment { rgb .6 } }

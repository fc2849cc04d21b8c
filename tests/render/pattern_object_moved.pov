// The object pattern: transformations behind the object move it alone, those
// of the pigment all that was before.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -6> look_at <0, .5, 0> angle 45 }
light_source { <-5, 8, -6>, 1 }
#declare Stencil = box { <-1, -.3, -2>, <1, .5, .5> };
plane { y, 0 pigment {
    object { Stencil scale <1, 1, .3> rotate y*30 rgb <.8, .1, .1> rgb 1 }
    turbulence .3 scale 1.5 } }
sphere { <-1.5, 1, 0>, 1 texture {
    object { Stencil rotate z*40 translate <-1.5, 1.4, 0>
        texture { pigment { rgb <.2, .6, .3> } }
        texture { pigment { rgb 1 } finish { phong 1 } } } } }
box { -.8, .8 pigment { rgb <.5, .6, .9> } normal {
    object { sphere { 0, 1 } scale <.4, 2, .9>
        normal { bumps 0 } normal { bumps 1 scale .1 } } }
    rotate y*30 translate <1.5, .8, 0> }
#declare Other = Stencil;
object { Other scale .3 translate <0, .1, -2> pigment { rgb <.9, .8, .2> } }

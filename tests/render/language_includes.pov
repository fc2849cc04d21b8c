// The standard includes colors, textures, shapes and transforms: names that
// most scenes in the world begin with.
// compare: exact
#version 3.7;
#include "colors.inc"
#include "textures.inc"
#include "shapes.inc"
#include "transforms.inc"
global_settings { assumed_gamma 1 }
camera { location <0, 3, -8> right 4/3*x look_at <0, .8, 0> angle 42 }
light_source { <-5, 9, -6>, White }
background { SkyBlue }
sphere { <-2.4, .8, 0>, .8 pigment { Orange } finish { Phong_Shiny } }
object { UnitBox scale .6 texture { Chrome_Texture } rotate 30*y
    translate <-.4, .61, .4> }
object { Disk_Y scale <.6, .5, .6> pigment { CoolCopper } finish { Dull }
    translate <1.2, .51, -.6> }
object { Cone_Y scale .6 pigment { Red*.6 + Blue*.4 } finish { Shiny }
    Axis_Rotate_Trans(<1, 1, 0>, 20) translate <2.7, .62, .3> }
sphere { <.5, .3, -2>, .3 pigment { Clear } finish { Glass_Finish } }
plane { y, -.01 pigment { checker Gray70, White translate .3 } }

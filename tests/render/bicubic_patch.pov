// bicubic_patch: steps along both ways; a texture.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -5> right 4*x up 3*y }
light_source { <-3, 4, -6>, 1 }
#default { pigment { rgb .9 } finish { ambient .1 diffuse .7 phong .4 } }
#macro Patch(U, V)
    bicubic_patch { type 1 flatness 0 u_steps U v_steps V
        <-1.5, -1, .5>, <-.5, -1.2, -1>, <.5, -1, -1>, <1.5, -1, 1>,
        <-1.5, -.3, -.5>, <-.5, -.4, 1>, <.5, -.3, -2>, <1.5, -.2, 0>,
        <-1.5, .3, 0>, <-.5, .4, -1>, <.5, .3, 1>, <1.5, .3, -.5>,
        <-1.5, 1, 0>, <-.5, 1.2, -.5>, <.5, 1, .5>, <1.5, 1.2, 0>
#end
Patch(4, 4) scale .6 rotate <3, 5, 7> translate <-1, .75, 0> }
Patch(2, 1) scale .6 rotate 30*y translate <1, .75, 0> }
Patch(1, 3) pigment { checker rgb 1 rgb <1, 0, 0> scale .3 } scale .6 rotate -30*x translate <-1, -.75, 0> }
Patch(3, 3) scale .6 rotate <10, -25, 4> translate <1, -.75, 0> }

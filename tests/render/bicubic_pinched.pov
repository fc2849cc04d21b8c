// Patches with a side drawn together to a point, as leaves are made: x is the
// normal there, wherever the patch was turned.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, .5, -2.4> look_at <0, .5, 0> }
light_source { <30, 40, -25>, 1 }
#default { pigment { rgb <.5, .9, .4> } }
#macro Leaf(Flatness, Steps)
    bicubic_patch {
        type 1 flatness Flatness u_steps Steps v_steps Steps,
        0, 0, 0, 0,
        <-.5, .25, .06>, <-.06, .25, 0>, <.06, .25, 0>, <.5, .25, .06>,
        <-.5, .75, .1>, <-.06, .75, 0>, <.06, .75, 0>, <.5, .75, .1>,
        y, y, y, y
        translate 0
#end
Leaf(0, 0) translate -x }
Leaf(0, 3) }
Leaf(.06, 3) scale <-1, 1, 1> translate x }
Leaf(.2, 3) scale <1, -1, 1> }

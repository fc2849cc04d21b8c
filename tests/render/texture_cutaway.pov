// cutaway_textures: what cuts has the textures of what it cuts; of several the
// mean.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1, 3, -5> look_at 0 angle 40 }
light_source { <-5, 8, -6>, 1 }
difference {
    union {
        sphere { 0, 1 pigment { checker rgb x rgb 1 scale .3 rotate 20 } }
        union {
            box { 0, 1 pigment { rgb <0, .8, .2> } scale 1.2 }
            sphere { <-1, 0, 0>, .7 }
            texture { pigment { wood scale .2 } }
            translate -.2
        }
    }
    box { <-3, -3, -3>, <3, 3, 0> rotate 10 * y }
    cutaway_textures
    rotate 5 * x
}

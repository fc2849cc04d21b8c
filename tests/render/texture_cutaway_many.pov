// cutaway_textures of many parts with textures.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -10> look_at 0 }
light_source { <3, 10, -10>, 1 }
difference {
    union {
        #declare I = 0;
        #while (I < 100)
            #declare X = mod(I, 10);
            sphere { <X - 4.5, floor(I / 10) - 4.5, 0>, .47
                pigment { rgb <X / 10, I / 100, .5> } finish { ambient .3 } }
            #declare I = I + 1;
        #end
    }
    box { -9, <9, 9, -.01> }
    cutaway_textures
}

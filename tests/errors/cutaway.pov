#version 3.7;
difference {
    union {
        #declare I = 0;
        #while (I < 1001)
            sphere { I * x, 1 pigment { rgb 1 } }
            #declare I = I + 1;
        #end
    }
    plane { z, 0 }
    cutaway_textures
}

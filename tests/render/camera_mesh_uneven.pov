// mesh_camera: three rays a pixel from meshes of different length; where the
// first has no triangle left, the mean is that of the others.
// compare: noise
#version 3.7;
global_settings { assumed_gamma 1 }
#macro Eye(Rows, Move)
    mesh {
        #declare J = 0;
        #while (J < Rows)
            #declare I = 0;
            #while (I < 160)
                #declare At = <I / 40 - 2 + Move, 1.5 - J / 40, -5>;
                triangle { At, At + .01*y, At + .01*x }
                #declare I = I + 1;
            #end
            #declare J = J + 1;
        #end
    }
#end
camera { mesh_camera { 3 0 Eye(40, 0) Eye(120, 0) Eye(120, .5) } }
light_source { <-5, 8, -9>, 1 }
sphere { 0, 1 pigment { rgb <1, .5, .2> } }
plane { y, -1 pigment { checker rgb 1, rgb <.2, .4, .8> } }
plane { -z, -5 pigment { rgb <.8, .3, .6> } }

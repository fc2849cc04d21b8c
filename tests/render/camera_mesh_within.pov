// mesh_camera: rays that begin in a fading ball, in front of the mesh by the
// location, don't know of it.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Eye = mesh {
    #for (J, 0, image_height - 1)
        #for (I, 0, image_width - 1)
            #local P = <(I - image_width / 2) / 25, (image_height / 2 - J) / 25, -4>;
            triangle { P, P + <.01, .02, .01 * sin(I / 9)>, P + .02 * x }
        #end
    #end
}
camera { mesh_camera { 1 0 mesh { Eye translate <0, 0, 2> } } location <0, 0, 2> }
light_source { <-5, 8, -6>, 1 }
sphere { <-.5, .3, -1>, 2
    pigment { rgbt <1, .9, .7, .8> }
    interior { fade_distance 1 fade_power 1001 fade_color <.2, .5, .3> }
}
plane { z, 3 pigment { checker rgb .8 rgb .4 } }

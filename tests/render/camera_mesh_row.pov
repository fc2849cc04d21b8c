// mesh_camera: two pictures beside each other, a mesh for each.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Eye = mesh {
    #for (J, 0, image_height - 1)
        #for (I, 0, image_width / 2 - 1)
            #local P = <(I - image_width / 4) / 25, (image_height / 2 - J) / 25, -4>;
            triangle { P, P + <.01, .02, .01 * sin(I / 9)>, P + .02 * x }
        #end
    #end
}
camera { mesh_camera { 1 2 mesh { Eye } mesh { Eye translate .2 * x } } }
light_source { <-5, 8, -6>, 1 }
sphere { 0, 1 pigment { rgb <.9, .6, .3> } }
plane { z, 3 pigment { checker rgb .8 rgb .4 } }

// mesh2: shared vertices with and without normals, a texture for the whole
// and one transform.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -7> right 4/3*x look_at <0, .5, 0> angle 45 }
light_source { <-5, 8, -7>, rgb 1 }
background { rgb <.2, .2, .25> }
#declare Points = 10;
#macro Ring(Rim) // the points of a dented disc, its centre last
    #local I = 0;
    #while (I < Points)
        #local A = 2*pi*I/Points;
        <cos(A), Rim*mod(I, 2), sin(A)>,
        #local I = I + 1;
    #end
    <0, .7, 0>
#end
#macro Faces()
    face_indices { Points,
        #local I = 0;
        #while (I < Points)
            <I, mod(I + 1, Points), Points>,
            #local I = I + 1;
        #end
    }
#end
mesh2 {
    vertex_vectors { Points + 1, Ring(.3) }
    Faces()
    pigment { rgb <.9, .5, .2> } scale 1.3 translate <-1.6, .1, 0>
}
mesh2 {
    vertex_vectors { Points + 1, Ring(0) }
    normal_vectors { Points + 1,
        #local I = 0;
        #while (I < Points)
            #local A = 2*pi*I/Points;
            <cos(A), .6, sin(A)>,
            #local I = I + 1;
        #end
        <0, 1, 0> }
    Faces()
    texture { pigment { rgb <.3, .7, .9> } finish { phong .7 phong_size 30 } }
    scale <1.3, 1.6, 1.3> rotate -20*z translate <1.6, .6, 0>
}
plane { y, -.05 pigment { rgb .6 } }

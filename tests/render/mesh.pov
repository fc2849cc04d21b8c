// mesh: flat and smooth triangles, a texture for single triangles, used twice
// by object{}, and as a solid by inside_vector.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1, 3, -7> right 4/3*x look_at <0, .6, 0> angle 45 }
light_source { <-5, 8, -7>, rgb 1 }
background { rgb <.2, .25, .3> }
#declare Red = texture { pigment { rgb <.9, .3, .2> } }
#declare Blue = texture { pigment { rgb <.3, .4, .9> } finish { phong .6 } }
#declare Pyramid = mesh {
    triangle { <-1, 0, -1>, <1, 0, -1>, <0, 1.6, 0> texture { Red } }
    triangle { <1, 0, -1>, <1, 0, 1>, <0, 1.6, 0> texture { Blue } }
    triangle { <1, 0, 1>, <-1, 0, 1>, <0, 1.6, 0> texture { Red } }
    triangle { <-1, 0, 1>, <-1, 0, -1>, <0, 1.6, 0> }
    triangle { <-1, 0, -1>, <1, 0, -1>, <1, 0, 1> }
    triangle { <-1, 0, -1>, <1, 0, 1>, <-1, 0, 1> }
    inside_vector <.1, 1, .2>
}
object { Pyramid pigment { rgb <.8, .8, .3> } rotate 25*y translate -1.9*x }
difference {
    object { Pyramid pigment { rgb <.4, .9, .5> } rotate -15*y }
    box { <-2, .8, -2>, <2, 3, 2> pigment { rgb .95 } }
    translate <1.4, 0, .3>
}
mesh {
    smooth_triangle { <-1, 0, 0>, <-1, 1, -1>, <1, 0, 0>, <1, 1, -1>,
        <0, 0, -1>, <0, 2, -1> texture { Blue } }
    smooth_triangle { <-1, .5, 1>, <-1, 1, -1>, <1, .5, 1>, <1, 1, -1>,
        <0, .5, .3>, <0, 2, -1> }
    pigment { rgb <.9, .7, .5> } translate <0, .05, -2>
}
plane { y, -.01 pigment { rgb .6 } }

// Arrays of numbers, vectors, colours and objects, of two dimensions, with
// initial values, dimensions and dimension_size; strings that make decisions.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -8> right 4/3*x look_at <0, .2, 0> angle 30 }
light_source { <-5, 9, -6>, rgb 1 }
#declare Heights = array[2][4] { { .3, .8, .5, 1.1 } { 1, .4, .9, .2 } }
#declare Colours = array[4] { rgb <.9, .3, .2>, rgb <.9, .8, .2>,
    rgb <.3, .8, .4>, rgb <.3, .4, .9> }
#declare Shapes = array[2];
#declare Shapes[0] = box { <-.35, 0, -.35>, <.35, 1, .35> }
#declare Shapes[1] = cylinder { 0, y, .35 }
#declare Names = array[2] { "box", "cyl" }
#declare R = 0;
#while (R < dimension_size(Heights, 1))
    #declare C = 0;
    #while (C < dimension_size(Heights, 2))
        object { Shapes[R] scale <1, Heights[R][C], 1>
            pigment { Colours[mod(C + R, 4)] }
            translate <C - 1.5, 0, 1.3*R> }
        #declare C = C + 1;
    #end
    #declare R = R + 1;
#end
#declare Size = dimensions(Heights)/10;
#if (strcmp(Names[0], "box") = 0 & strlen(concat(Names[0], Names[1])) = 6)
    sphere { <-1.5, Size, -1.4>, Size pigment { Colours[0] } }
#end
#if (strcmp(strupr(substr("glimmer", 2, 3)), "LIM") = 0)
    sphere { <-.5, .3, -1.4>, val("0.3") pigment { Colours[1] } }
#end
#if (strcmp(str(2.345, 6, 2), "  2.35") + strcmp(chr(65), "A") = 0)
    sphere { <.5, .3, -1.4>, asc("2")/200 pigment { Colours[2] } }
#end
#if (strcmp(vstr(3, <1, 2, 3>, ",", 0, 0), "1,2,3") = 0)
    sphere { <1.5, .3, -1.4>, .3 pigment { Colours[3] } }
#end
// Arrays in an array: objects, textures and colours of theirs.
#declare Nested = array[2];
#declare Nested[0] = array[2] { sphere { 0, .2 }, box { -.15, .15 } }
#declare Nested[1] = array[1] { torus { .2, .08 } }
#declare Paints = array[1];
#declare Paints[0] = array[2] { texture { pigment { rgb <.8, .3, .8> } },
    texture { pigment { rgb <.2, .7, .7> } finish { phong .5 } } }
#declare Lists = array[1];
#declare Lists[0] = Colours;
object { Nested[0][0] texture { Paints[0][1] } translate <-1, .2, -2.2> }
object { Nested[0][1] texture { Paints[0][0] } translate <0, .2, -2.2> }
object { Nested[1][0] pigment { Lists[0][2] } translate <1, .2, -2.2> }
plane { y, -.01 pigment { rgb .6 } }

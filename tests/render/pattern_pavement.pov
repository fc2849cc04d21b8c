// Pavements of triangles, squares and hexagons, with all forms of corners, in
// pigments and a normal.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -5> look_at 0 right 8*x up 6*y }
light_source { <-5, 8, -9> rgb 1 }
#declare Pavements = array[12] {
  pigment { pavement },
  pigment { pavement number_of_tiles 6 pattern 9 exterior 1 interior 1 form 1 },
  pigment { pavement number_of_tiles 5 pattern 3 exterior 2 interior 2 form 2 },
  pigment { pavement number_of_sides 4 number_of_tiles 4 pattern 3 },
  pigment { pavement number_of_sides 4 number_of_tiles 5 pattern 7 form 1 },
  pigment { pavement number_of_sides 4 number_of_tiles 6 pattern 30
            interior 2 exterior 2 form 2 },
  pigment { pavement number_of_sides 4 number_of_tiles 6 pattern 14
            interior 1 exterior 1 form 3 },
  pigment { pavement number_of_sides 6 turbulence .2 },
  pigment { pavement number_of_sides 6 number_of_tiles 3 pattern 2 form 1 },
  pigment { pavement number_of_sides 6 number_of_tiles 4 pattern 7 form 2 },
  pigment { pavement number_of_sides 6 number_of_tiles 5 pattern 8 interior 2 },
  pigment { rgb <.8, .7, .6> }
}
#for (I, 0, 11)
  box {
    <0, 0, 0>, <1.9, 1.9, 0.1>
    #if (I = 11)
      pigment { Pavements[I] }
      normal { pavement .6 number_of_sides 4 number_of_tiles 3 pattern 2
               scale .2 rotate -90*x }
    #else
      pigment { Pavements[I]
        color_map { [0 rgb <.1, .2, .4>] [.5 rgb <.8, .5, .2>] [1 rgb 1] }
        scale .2 rotate <-90, 0, I*3> }
    #end
    finish { ambient .4 diffuse .6 }
    translate <mod(I, 4)*2 - 4, div(I, 4)*2 - 3, 0>
  }
#end

// The 27 tilings, in pigments and a normal.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -5> look_at 0 right 8*x up 6*y }
light_source { <-5, 8, -9> rgb 1 }
#for (I, 0, 26)
  box {
    <0, 0, 0>, <1.12, 1.4, 0.1>
    #if (I = 10)
      pigment { rgb <.8, .7, .6> } normal { tiling 10 0.6 scale .3 rotate -90*x }
    #else
      pigment { tiling I + 1
        color_map { [0 rgb <.1, .2, .4>] [.5 rgb <.8, .5, .2>] [1 rgb 1] }
        scale .2 rotate <-90, 0, I*3> }
    #end
    finish { ambient .4 diffuse .6 }
    translate <mod(I, 7)*1.14 - 4, div(I, 7)*1.5 - 3, 0>
  }
#end

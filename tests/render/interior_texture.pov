// interior_texture: solids, CSG, surfaces without an inside, layers, materials.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0,3.5,-11> look_at -.8*y angle 40 right 4/3*x }
light_source { <-6, 9, -8>, rgb 1 }
light_source { <6, 9, 8>, rgb <.3,.3,.5> }
background { rgb <.2,.3,.3> }
#declare TX = texture { pigment { rgb <1,1,0> } }
#declare A = texture { pigment { checker rgb <.9,.2,.1> rgbt 1 scale .3 } finish { phong .5 } }
#declare B = texture { pigment { gradient y color_map { [0 rgb <.1,.2,.8>] [1 rgb <.9,.9,.2>] } scale .4 } normal { bumps 0 } }
sphere { 0,1 texture { A } interior_texture { B } translate <-2.4,1.2,0> rotate 10*y}
box { -.8,.8 texture { A } interior_texture { B scale 2 rotate 45*z } rotate 30*y translate <0,1.2,0> }
sphere { 0,1 pigment { rgb 1 } interior_texture { B } clipped_by { plane { z, 0 } rotate 40*y} scale <1,.8,1> translate <2.4,1.2,0> }
difference { box { -1,1 } box { <-.5,-.5,-2>,<.5,2,2> } texture { A } interior_texture { B } scale .8 rotate 20*x translate <-2.4,-1.2,0> }
union { sphere { 0,.6 } box { <-.2,-1.2,-.2>,<.2,1.2,.2> texture { A } interior_texture { pigment { rgb <1,0,1> } } } texture { A } interior_texture { B } translate <0,-1.2,0> }
disc { 0, <.3,.4,1>, 1,.3 texture { pigment { rgb x } } interior_texture { pigment { rgb y } } translate <2.4,-1.2,0> }
mesh { triangle { <-1,0,0>,<0,1,0>,<1,0,0> } triangle { <-1,-1,0>,<1,-1,0>,<0,-.1,0> } texture { pigment { rgb x } } interior_texture { pigment { rgb z } } scale .6 translate <3.7,-1.2,-.3> }
plane { y, -4 texture { pigment { checker rgb .6 rgb .8 } } interior_texture { pigment { rgb x } } }
mesh { triangle { <-1,0,0>,<0,1,0>,<1,0,0> texture { TX } } triangle { <-1,-1,0>,<1,-1,0>,<0,-.1,0> texture { TX } } texture { pigment { rgb x } } interior_texture { pigment { rgb z } } scale .4 translate <3.0,-2.5,-.3> }
triangle { <-1,0,0>,<0,1,0>,<1,0,0> texture { TX } interior_texture { pigment { rgb z } } scale .4 translate <2.0,-2.5,-.3> }
smooth_triangle { <-1,-1,0>,<.2,.1,1>,<1,-1,0>,<0,.1,1>,<0,-.1,0>,<0,-.1,1> texture { TX } interior_texture { pigment { rgb z } } scale .4 translate <1.0,-2.5,-.3> }
height_field { function 20,20 { x*y } texture { pigment { rgb x } } interior_texture { pigment { rgb z } } rotate -60*x scale .8 translate <-2,-2.5,-2> }
height_field { function 20,20 { x*y } texture { pigment { rgb x } } interior_texture { pigment { rgb z } } rotate 60*x scale .8 translate <-1,-2.5,-2> }
bicubic_patch { type 1 flatness 0 u_steps 3 v_steps 3
    <-1, -1, 0>, <-.5, -1, -1>, <.5, -1, 1>, <1, -1, 0>
    <-1, -.5, 0>, <-.5, -.5, 0>, <.5, -.5, 0>, <1, -.5, 0>
    <-1, .5, 0>, <-.5, .5, -.6>, <.5, .5, .4>, <1, .5, 0>
    <-1, 1, 0>, <-.5, 1, 0>, <.5, 1, 0>, <1, 1, 0> texture { pigment { rgb x } } interior_texture { pigment { rgb z } } scale .4 translate <0,-2.3,-2> }
#declare M = material { texture { TX } interior_texture { B } interior_texture { pigment { gradient x color_map { [.5 rgbt 1] [.5 rgb 0] } scale .3 } } }
sphere { 0, .5 material { M } clipped_by { plane { -y, 0 } } rotate -50*x scale 1.2 translate <.8, -2.6, -2> }

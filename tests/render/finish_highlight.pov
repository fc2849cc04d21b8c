// phong and specular: sizes, albedo, metallic with and without a value; two
// lights of different colours.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -9> right 8*x up 6*y }
light_source { <-6, 7, -9>, rgb 1 }
light_source { <8, -2, -5>, rgb <.3, .5, 1> }
background { rgb .05 }
#default { finish { ambient .05 diffuse .4 } }
#macro Ball(Column, Row, F)
    sphere { 0, .85 pigment { rgb <.8, .4, .2> }
        finish { F }
        translate <1.95*Column - 2.92, 1.95 - 1.95*Row, 0> }
#end
Ball(0, 0, finish { phong .8 })
Ball(1, 0, finish { phong .8 phong_size 8 })
Ball(2, 0, finish { phong .8 phong_size 150 })
Ball(3, 0, finish { phong albedo .2 phong_size 20 })
Ball(0, 1, finish { specular .7 })
Ball(1, 1, finish { specular .7 roughness .2 })
Ball(2, 1, finish { specular .7 roughness .004 })
Ball(3, 1, finish { specular albedo .2 roughness .05 })
Ball(0, 2, finish { phong .8 phong_size 12 metallic })
Ball(1, 2, finish { specular .8 roughness .1 metallic .5 })
Ball(2, 2, finish { phong .4 specular .5 metallic 1 })
Ball(3, 2, finish { diffuse 0 phong 1 phong_size 3 })

// ambient, emission, diffuse as numbers and colours, brilliance, the back
// side's diffuse, diffuse albedo; a light behind and one in front.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 ambient_light rgb <.8, 1, 1.4> }
camera { orthographic location <0, 0, -9> right 8*x up 6*y }
light_source { <-4, 5, -9>, rgb 1 }
light_source { <5, -4, 9>, rgb <.9, .6, .3> }
#macro Ball(Column, Row, F)
    sphere { 0, .85 pigment { rgb <.8, .7, .5> } finish { F }
        translate <1.95*Column - 2.92, 1.95 - 1.95*Row, 0> }
#end
Ball(0, 0, finish { ambient .4 diffuse 0 })
Ball(1, 0, finish { ambient rgb <.6, .1, .1> diffuse .5 })
Ball(2, 0, finish { ambient 0 emission .3 diffuse .4 })
Ball(3, 0, finish { ambient 0 emission rgb <.1, .5, .2> diffuse .3 })
Ball(0, 1, finish { ambient 0 diffuse .9 brilliance .5 })
Ball(1, 1, finish { ambient 0 diffuse .9 brilliance 3 })
Ball(2, 1, finish { ambient 0 diffuse albedo .6 brilliance 3 })
Ball(3, 1, finish { })
#macro Leaf(Column, F)
    disc { 0, z, .85 pigment { rgb <.8, .7, .5> } finish { F }
        rotate <10, 20, 0> translate <1.95*Column - 2.92, -1.95, 0> }
#end
Leaf(0, finish { ambient 0 diffuse .5 })
Leaf(1, finish { ambient 0 diffuse .5, .9 })
Leaf(2, finish { ambient 0 diffuse albedo .5, .4 brilliance 2 })
disc { 0, z, .85 pigment { rgb <.8, .7, .5> } finish { ambient 0 diffuse .6 }
    double_illuminate rotate <10, 20, 0> translate <2.93, -1.95, 0> }

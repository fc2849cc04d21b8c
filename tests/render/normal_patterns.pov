// Patterns that need no noise as normals: gradient and onion waves, marble
// and wood, brick and checker edges, and bump_size.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -5> right 4*x up 3*y }
light_source { <-60, 80, -100>, rgb 1 parallel point_at 0 }
#default { pigment { rgb <.8, .75, .7> } finish { ambient 0 diffuse 1 } }
#macro Tile(Column, Row, N)
    box { <-.64, -.72, 0>, <.64, .72, .1> normal { N translate .02 }
        translate <1.33*Column - 1.33, .75 - 1.5*Row, 0> }
#end
Tile(0, 0, normal { gradient x 1 sine_wave scale .4 })
Tile(1, 0, normal { onion .8 sine_wave scale .3 })
Tile(2, 0, normal { marble 1 bump_size .5 scale .3 })
Tile(0, 1, normal { wood .6 scale .3 })
Tile(1, 1, normal { leopard 2 scale .04 })
Tile(2, 1, normal { radial 1 frequency 5 sine_wave rotate 90*x })

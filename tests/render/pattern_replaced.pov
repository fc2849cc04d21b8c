// A declared pigment or normal whose pattern is replaced by another keeps its
// wave form, unless the new pattern has its own, and its map; a list of colours
// is a map then. The same of what #default says: a bump_size alone, too.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -10> look_at 0 right 8*x up 6*y }
light_source { <-100, 200, -300> rgb 1 }
#declare Column = 0;
#declare Row = 0;
#macro Tile()
    box {
        <Column - 4, 2 - Row, 0>, <Column - 3.05, 2.95 - Row, 1>
        #declare Column = mod(Column + 1, 8);
        #declare Row = Row + (Column = 0);
    }
#end
#declare Red = pigment {
    gradient y sine_wave color_map { [0 rgb 0] [1 rgb x] }
}
#declare Poly = pigment { gradient y poly_wave 3 frequency 2 phase .2 }
#declare Marble = pigment { marble color_map { [0 rgb z] [1 rgb 1] } }
#declare Checker = pigment { checker rgb x rgb z }
#declare Hexagon = pigment { hexagon rgb x rgb z rgb y scale .3 }
object { Tile() pigment { Red gradient x } }
object { Tile() pigment { Red radial rotate 90*x } }
object { Tile() pigment { Red wood scale .3 } }
object { Tile() pigment { Red marble scale .5 } }
object { Tile() pigment { Red spiral1 2 scale .2 } }
object { Tile() pigment { Red leopard scale .1 } }
object { Tile() pigment { Red function { x*x + y } } }
object { Tile() pigment { Poly gradient x } }
object { Tile() pigment { Poly onion scale .4 } }
object { Tile() pigment { Poly gradient x color_map { [0 rgb x] [1 rgb y] } } }
object { Tile() pigment { Marble gradient y } }
object { Tile() pigment { Marble spherical scale 5 } }
object { Tile() pigment { Marble gradient y ramp_wave } }
object { Tile() pigment { Checker gradient y scale .6 } }
object { Tile() pigment { Checker brick scale .1 } }
object { Tile() pigment { Hexagon gradient y scale 6 } }
object { Tile() pigment { Hexagon leopard } }
#default { pigment { gradient x triangle_wave scale .4 } }
object { Tile() pigment { gradient y } }
object { Tile() pigment { onion scale 2 } }
#default { pigment { gradient x pigment_map { [0 rgb 1] [1 Checker] } } }
object { Tile() pigment { gradient y } }
object { Tile() pigment { boxed } }
object { Tile() pigment { rgb y } }
#declare Bare = normal { bump_size 1.5 }
#declare Mapped = normal { gradient z normal_map { [0 gradient y 3] } }
#declare Sloped = normal {
    gradient z slope_map { [0 <0, 1>] [1 <3, 0>] } scale .6
}
#declare Blocks = normal {
    checker normal { gradient x 2 } normal { gradient y 2 } scale .3
}
#declare Waved = normal { gradient y 1.5 scallop_wave scale .3 }
#declare N = normal { Bare gradient x }
object { Tile() pigment { rgb 1 } normal { N } }
#declare N = normal { Mapped gradient x }
object { Tile() pigment { rgb 1 } normal { N } }
#declare N = normal { Sloped gradient x }
object { Tile() pigment { rgb 1 } normal { N } }
#declare N = normal { Blocks gradient x }
object { Tile() pigment { rgb 1 } normal { N } }
#declare N = normal { Blocks checker }
object { Tile() pigment { rgb 1 } normal { N } }
#declare N = normal { Waved gradient x }
object { Tile() pigment { rgb 1 } normal { N } }
#declare N = normal { Waved onion }
object { Tile() pigment { rgb 1 } normal { N } }
#declare N = normal { Waved marble }
object { Tile() pigment { rgb 1 } normal { N } }
#default { normal { bump_size 1.5 scale .3 } }
#declare N = normal { gradient x }
object { Tile() pigment { rgb 1 } normal { N } }
#declare N = normal { gradient x .5 }
object { Tile() pigment { rgb 1 } normal { N } }
#declare N = normal { gradient z normal_map { [0 gradient y] [1 gradient x] } }
object { Tile() pigment { rgb 1 } normal { N } }
#declare N = normal { checker normal { gradient x } normal { onion } }
object { Tile() pigment { rgb 1 } normal { N } }
#declare N = normal { average normal_map { [1 gradient x] [2 gradient y] } }
object { Tile() pigment { rgb 1 } normal { N } }
#declare Later = normal { onion }
#declare N = normal { Later }
object { Tile() pigment { rgb 1 } normal { N } }
#default { normal { gradient x 1.5 } }
#declare N = normal { gradient y }
object { Tile() pigment { rgb 1 } normal { N } }
#declare N = normal { triangle_wave scale .2 }
object { Tile() pigment { rgb 1 } normal { N } }

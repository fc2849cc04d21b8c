// The functions that give a number, and those of arrays: each value makes the
// colour of one tile.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -5> right 9*x up 6*y }
#default { finish { ambient 0 diffuse 0 emission 1 } }
#declare Tiles = 0;
// Red shows the size, green and blue the decimals, clear of their wraps.
#macro Tile(V)
    box { 0, <.98, .98, .1>
        pigment { rgb <.1 + .13*abs(V), abs(mod(.737*V + .013, 1)),
            abs(mod(3.391*V + .017, 1))> }
        translate <mod(Tiles, 9) - 4.5, 2 - int(Tiles/9), 0> }
    #declare Tiles = Tiles + 1;
#end
Tile(abs(-2)) Tile(ceil(2.2)) Tile(floor(-2.2)) Tile(int(-2.7)) Tile(div(17, 5))
Tile(mod(-7, 3)) Tile(max(1, 4, 2)) Tile(min(3, 1.5, 2)) Tile(pow(1.7, 3))
Tile(sqrt(7)) Tile(exp(1.3)) Tile(ln(20)) Tile(log(500)) Tile(sin(2)*3)
Tile(cos(2)*3) Tile(tan(1)) Tile(asin(.6)*3) Tile(acos(.6)*3) Tile(atan2(2, -3))
Tile(sinh(1.2)) Tile(cosh(1.2)) Tile(tanh(.6)*4) Tile(asinh(3)) Tile(acosh(5))
Tile(atanh(.7)*3) Tile(radians(160)) Tile(degrees(.06)) Tile(select(-1, 2, 3, 4))
Tile(select(0, 2, 3, 4)) Tile(select(1, 2, 5)) Tile(bitwise_and(7, 5))
Tile(bitwise_or(1, 4)) Tile(bitwise_xor(7, 3)) Tile(2 + 3*1.5 - 4/2)
Tile(-2*-1.5) Tile((1 < 2) + (3 >= 3) + 1) Tile((1 & 0) + (1 | 0)*2)
Tile(!0 + 1) Tile((5 = 5)*3) Tile((2 != 2) + .5) Tile(pi) Tile(clock + 1)
Tile(version) Tile(image_width/40) Tile((1 ? 3 : 5)) Tile(vlength(<1, 2, 2>))
Tile(vdot(<1, 2, 3>, <.5, .5, 1>)) Tile(val("1.25e0")*3) Tile(strlen("four"))
Tile(asc("!")/10) Tile(defined(Tiles)*2.5)
Tile(1e1/4) Tile(.5e-1*60)
// Of arrays.
#declare Fns = array[2] { function(a) { a*a }, function(a, b) { a - b } }
#declare Both = function(a) { Fns[0](a) + Fns[1](a, 1) }
Tile(Fns[0](1.5) + Fns[1](5, 4.5) + Both(1))

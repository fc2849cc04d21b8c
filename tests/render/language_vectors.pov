// The functions and operators that give a vector: each places one ball;
// swizzled components, promotion, colours as vectors.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -10> right 4/3*x look_at <0, .8, 0> angle 42 }
light_source { <-5, 9, -6>, rgb 1 }
#macro Ball(P, C) sphere { P + <0, .3, 0>, .3 pigment { C } } #end
#declare Block = box { <1, 1.4, 3>, <4, 5, 6> }
#declare Egg = sphere { <2.6, 1, .5>, .5 scale <1, 1.4, 1> }
#declare V = <1, .5, -1>;
Ball(V, rgb <.9, .2, .2>)
Ball(vcross(<1, 0, 2>, <.3, 2, 1>)/2, rgb <.9, .5, .2>)
Ball(vnormalize(<3, 1, -4>)*3, rgb <.9, .8, .2>)
Ball(vrotate(3*x, <0, 70, 25>), rgb <.6, .9, .2>)
Ball(vaxis_rotate(<2, 0, 1>, <.2, 1, .1>, 140), rgb <.2, .9, .3>)
Ball(<V.x - 3, V.y*2, V.z - 1>, rgb <.2, .9, .8>)
Ball(-2*x + y/2, rgb <.2, .6, .9>)
Ball(V*<-1, 1, 2> + <0, .2, 0>, rgb <.2, .2, .9>)
Ball((1 + <2, 0, -3>), rgb <.5, .2, .9>)
#declare C = rgbf <.8, .3, .6, .25>;
Ball(<-3.2, .4, -2>, rgb <C.red, C.green, C.blue>)
Ball(<-3.4, C.filter*4, .6>, color C*1.2)
Ball(<C.gray*4, 1.6, 1>, rgb C.x)
Ball(<0, min_extent(Block).y, 2>, rgb .9)
Ball(max_extent(Egg) - <.5, 0, 0>, rgb .5)
Ball(vrotate(<0, 1.4, 1>, 50*x - 30*z), rgb <.9, .6, .7>)
plane { y, -.01 pigment { rgb .6 } }

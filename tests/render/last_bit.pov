// Colours that the last bit of where a ray meets a surface decides: `onion` is 1
// or 0 at a radius of 1, and the fold of large values shows what is far behind
// the point.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <-1.2, 2.4, -4> angle 35 look_at <0, .2, .1> }
#default { finish { ambient 1 diffuse 0 } }
sphere { <.1, .2, .3>, 1
  pigment { onion color_map { [.5 rgb x] [.5 rgb y] } translate <.1, .2, .3> } }
plane { y, -1 pigment { function { x*1e12 - floor(x*1e12) } } }
plane { -z, 0
  pigment { magnet 1 mandel 50 interior 1, 200 exterior 5, 1
    color_map { [0 rgb <1, .8, .5>] [1 rgb <.2, .5, .8>] } scale 2 }
  rotate 60*x translate -.6*y }
// What is moved is moved itself, or rays are taken into its space by the very
// inverse of what it was turned by.
#macro Fold(Way) pigment { function { x*1e12 - floor(x*1e12) } rotate Way } #end
quadric { <1,1.3,1.2>, <.1,.2,.3>, <.1,.2,.13>, -.1 translate <1.3,1,-1> Fold(0) }
quadric { <1,1.3,1.2>, <.1,.2,.3>, 0, -.1 rotate 30*y Fold(90*y) }
box { -.2, .3 scale <1.1,.7,.3> translate <-1.3,1.2,0> Fold(90*z) }
box { -.2, .3 rotate <10,20,30> Fold(0) }
union { sphere { 0, .4 } quadric { <1,0,1>, 0, 0, -.01 }
  scale 1.1 translate <-1.4,.1,-.3> Fold(0) }

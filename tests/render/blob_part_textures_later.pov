// Textures of parts, where the blob's own comes later: from a declared object's
// user, or from the union it is in.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -9> look_at 0 right 8*x up 6*y }
light_source { <-3, 5, -9> 1 }
#declare B = blob {
  threshold 0.6
  sphere { 0, 1, 1 }
  sphere { <.3, .3, -.5>, .6, 1 pigment { rgb x } }
  cylinder { -z*2, z, 0.04, -1 translate <-0.2, -0.3, 1> pigment { rgb y } }
  sphere { 0, 1, 1 scale <0.3, 0.9, 1.05> }
}
#declare Own = texture { pigment { checker rgb <.2, .5, .9> rgb 1 scale .2 } }
object { B texture { Own } scale 1.4 translate <-2.5, 1.4, 0> }
union { object { B rotate 20*z scale 1.4 } texture { Own } translate <0, 1.4, 0> }
union {
  difference { object { B } plane { y, -.2 } }
  texture { Own } texture { pigment { rgbt <1, 1, 0, .5> } }
  scale 1.4 translate <2.5, 1.4, 0>
}
object { B scale 1.4 translate <-2.5, -1.4, 0> }
#default { pigment { rgb <.6, .3, .6> } }
object { B scale 1.4 translate <0, -1.4, 0> }

// Lists of blocks that are too short: missing pigments, normals and textures
// are the default ones, missing colours the pattern's.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
#default {
  pigment { rgb <0, .3, .9> }
  normal { ripples .7 scale .1 }
  finish { ambient .4 }
}
camera { location <0, 0, -9> right 4/3*x look_at 0 angle 40 }
light_source { <-5, 8, -6> rgb 1 }
#macro At(I, J) translate <1.5*(I - 1.5), 1.5*(1 - J), 0> #end
#declare B = box { -.6, .6 rotate <20, 30, 0> }
object { B pigment { checker pigment { rgb x } scale .3 } At(0, 0) }
object { B pigment { brick pigment { rgb y } scale .08 } At(1, 0) }
object { B pigment { hexagon pigment { rgb x } pigment { rgb 1 } scale .2 } At(2, 0) }
object { B pigment { checker rgb x scale .3 } At(3, 0) }
object { B texture { checker texture { pigment { rgb x } finish { ambient 0 } } scale .3 } At(0, 1) }
object { B texture { hexagon texture { pigment { rgb x } } scale .2 } At(1, 1) }
object { B pigment { rgb 1 } normal { checker normal { bumps 1 scale .1 } scale .3 } At(2, 1) }
object { B pigment { object { sphere { 0, .7 } rgb <1, 1, 0> } } At(3, 1) }
object { B pigment { object { sphere { 0, .7 } pigment { rgb <1, 1, 0> } } } At(0, 2) }
object { B pigment { object { sphere { 0, .7 } } } At(1, 2) }

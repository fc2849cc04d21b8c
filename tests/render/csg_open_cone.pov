// Open cones and cylinders in CSG: their ends count as inside, and what they
// are taken from is open there.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 7, -7> right 4/3*x look_at <0, .2, 0> angle 40 }
light_source { <-5, 9, -6> rgb 1 }
plane { y, -.2 pigment { checker rgb .8 rgb .4 } }
#default { pigment { rgb <.6, .7, .9> } }
difference {
  cone { 0, .8, y, 1.1 pigment { rgb <.9, .5, .1> } }
  cone { 0, .6, y, 1 open }
  translate <-2, 0, 0>
}
difference {
  box { <-1, 0, -1>, 1 pigment { rgb <.9, .5, .1> } }
  cylinder { .3*y, y, .8 open }
  translate <.6, 0, 1>
}
difference {
  cone { 1.2*y, .4, 0, 1.2 open pigment { rgb x } }
  box { <-3, -1, -3>, <3, 3, 0> }
  cone { 1.2*y, .2, 0, 1 pigment { rgb y } }
  rotate -60*x translate <2.2, 1.1, -1>
}

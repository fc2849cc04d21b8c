// Light that goes through wax: round, on edges, behind a shadow, one colour
// farther than the others; a plain finish beside it.
// compare: noise
#version 3.7;
global_settings {
  assumed_gamma 1
  mm_per_unit 10
  subsurface { samples 200, 50 }
}
camera { location <0, 3, -6> look_at <0, .3, 0> angle 45 }
light_source { <-5, 8, -6> rgb 1 }
light_source { <6, 3, 4> rgb <.5, .4, .3> }
#declare Wax = finish { ambient .1 diffuse .8
  subsurface { translucency <3, 1.5, .5> } }
#declare Stone = finish { ambient 0 diffuse 1 specular .3
  subsurface { translucency .1 } }
plane { y, -.7 pigment { checker rgb .8 rgb .4 } finish { diffuse .7 } }
sphere { <-1.3, .3, 0>, 1 pigment { rgb <.9, .7, .4> } finish { Wax }
  interior { ior 1.4 } }
box { <.2, -.7, -.5>, <1.4, 1, .5> pigment { rgb <.9, .9, .8> } finish { Wax }
  interior { ior 1.3 } rotate 20*y }
sphere { <2.3, -.2, -.5>, .5 pigment { rgb <.3, .6, .3> } finish { Stone } }
cylinder { <.4, -.7, -1.5>, <.4, 0, -1.5>, .3 pigment { rgb <.9, .6, .6> }
  finish { Wax } interior { ior 1.4 } }

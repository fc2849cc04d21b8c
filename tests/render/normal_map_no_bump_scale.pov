// no_bump_scale of a normal_map counts for all that is in it, at any depth; its
// normals are blended as long as they have become, but those of maps in it as
// unit ones.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -12> look_at 0 angle 38 }
light_source { <-5, 8, -20> rgb 1 }
#declare At = -3;
#macro Bumpy (Y, Normal)
  box { -.9, .9 rotate <-20, 25, 0> translate <At, Y, 0>
    pigment { rgb <.4, .9, .3> } normal { Normal } finish { specular .4 } }
  #declare At = At + 2;
#end
#declare Map = normal { gradient x normal_map { [0 bumps .3 scale .1] [1 dents .5 scale .3] } scale .2 }
Bumpy(1.2, normal { cells normal_map { [0 bumps .3 scale .1] [.5 spotted .5 scale .2]
  [1 leopard .7 scale .1] } scale .3 no_bump_scale })
Bumpy(1.2, normal { average normal_map { [1 bumps .3 scale .1] [2 waves .2 scale .3] }
  scale <.5, 1, .2> no_bump_scale })
Bumpy(1.2, normal { checker normal { bumps .4 scale .2 } normal { wrinkles .3 }
  scale .3 no_bump_scale })
Bumpy(1.2, normal { gradient x normal_map { [0 bumps .3 scale .1] [1 quilted 0] } no_bump_scale })
#declare At = -3;
Bumpy(-1.2, normal { gradient y normal_map { [0 Map] [1 granite .3] } no_bump_scale scale .7
  rotate 20 })
Bumpy(-1.2, normal { gradient y normal_map { [0 gradient x normal_map { [0 bumps .3 scale .1]
  [1 dents .5 scale .3] } no_bump_scale scale .2] [1 granite .3] } scale .7 rotate 20 })
Bumpy(-1.2, normal { checker normal { Map } normal { average normal_map { [1 Map] [1 bumps .2] } }
  scale .4 no_bump_scale })
Bumpy(-1.2, normal { average normal_map { [1 Map] [2 wrinkles .2] } no_bump_scale })

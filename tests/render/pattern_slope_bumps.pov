// slope and aoi see the bumps that were worked out last: the layer's own, those
// of the layer above, those of the texture before in a map, there in the space
// of the map.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z look_at 0 right 8*x up 6*y }
#declare Bumps = texture { pigment { rgb <1, 0, 0> } finish { ambient .3 diffuse 0 }
                           normal { bumps 1 scale .3 } }
#declare Clear = texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 }
                           normal { bumps 1 scale .3 } }
#declare Steep = texture { pigment { slope y
  color_map { [0 rgb <0, 1, 0>] [1 rgb <0, 0, 1>] } } finish { ambient 1 diffuse 0 } }
#declare Facing = texture { pigment { aoi
  color_map { [0 rgb <0, 1, 0>] [1 rgb <0, 0, 1>] } } finish { ambient 1 diffuse 0 } }
#declare Chosen = texture { slope y texture_map { [.3 Steep] [.7 Bumps] } }
#declare Ball = sphere { 0, .9 }
#macro Moved(I) scale <1, .8, .9> rotate <10, 0, 20>
  translate <mod(I, 4)*2 - 3, 2 - 2*div(I, 4), 0> #end
object { Ball texture { Steep normal { bumps 1 scale .3 } } Moved(0) }
object { Ball texture { Steep } texture { Clear } Moved(1) }
object { Ball texture { Bumps } texture { Steep } Moved(2) }
object { Ball texture { average texture_map { [1 Bumps] [1 Steep] } } Moved(3) }
object { Ball texture { average texture_map { [1 Steep] [1 Bumps] } } Moved(4) }
object { Ball texture { gradient y translate .5*y scale 2 rotate 30*z
  texture_map { [0 Steep] [1 Bumps] } } Moved(5) }
object { Ball texture { average texture_map { [1 Bumps] [1 Facing] } } Moved(6) }
object { Ball texture { average texture_map { [1 Bumps] [1 Chosen] } } Moved(7) }
object { Ball texture { average texture_map { [1 gradient x scale 3 texture_map {
  [0 Bumps] [1 Bumps] } ] [1 Steep] } } Moved(8) }
object { Ball texture { average texture_map {
  [1 Bumps] [1 Steep normal { bumps .2 scale .1 } ] } } Moved(9) }

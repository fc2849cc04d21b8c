// The plates of plates.pov, of which only the one that glows is seen. What it
// gets in return has met two surfaces: whoever looks no farther than one finds
// nothing there, and would leave it out.
// claims: bounced
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location z direction -z right 6.4*x up 4.8*y }
plane { z, 0 pigment { rgb <.5, .8, .2> }
  finish { ambient 0 diffuse 1 emission <.6, .25, .5> } }
plane { -z, -2 pigment { rgb <.4, .6, .9> } finish { ambient 0 diffuse 1 } }

// A texture may begin with several names: a texture, pigments, normals,
// finishes; the last of each counts.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> look_at 0 angle 40 }
light_source { <-5, 8, -6>, 1 }
#declare P = pigment { checker rgb x rgb 1 scale .3 }
#declare Q = pigment { rgb <.9, .6, .3> }
#declare N = normal { bumps .6 scale .2 }
#declare F = finish { phong 1 ambient .3 }
#declare T = texture { P }
sphere { <-1, 0, 0>, 1 texture { Q P N F scale 2 } }
sphere { <1, 0, 0>, 1 texture { T F N finish { diffuse .9 } } }

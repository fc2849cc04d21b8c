// Before version 3.5 noise was cut to [0,1]; a later #version counts for what
// came before it, too.
// compare: exact
// options: +W320 +H240
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -5> right 4*x up 3*y }
light_source { <0, 0, -100>, rgb 1 parallel point_at 0 }
#default { finish { ambient 0 diffuse 1 } }
box { <-2, 0, 0>, <2, 1.5, .1> pigment { bozo scale .1 } }
#version 3.1;
box { <-2, -1.5, 0>, <0, 0, .1> pigment { wrinkles scale .1 } }
box { <0, -1.5, 0>, <2, 0, .1> pigment { wood turbulence .3 scale .2 } }

// Bumps, dents and wrinkles as normals on a lit floor and spheres.
// compare: exact
// options: +W320 +H240
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -5> right 4*x up 3*y }
light_source { <-60, 80, -100>, rgb 1 parallel point_at 0 }
#default { pigment { rgb <.8, .75, .7> } finish { ambient 0 diffuse 1 phong .3 } }
box { <-2, .5, 0>, <2, 1.5, .1> normal { bumps .7 scale .035 } }
box { <-2, -.5, 0>, <2, .5, .1> normal { dents 2 scale .03 } }
box { <-2, -1.5, 0>, <2, -.5, .1> normal { wrinkles .7 scale .04 } }

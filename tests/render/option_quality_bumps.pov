// +Q7: no bumps yet, in plain textures, layers and lists.
// compare: exact
// options: +Q7
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at 0 }
light_source { <-4, 6, -5>, 1 }
sphere { -1.1*x, 1 pigment { granite } normal { wrinkles 1 }
    finish { reflection .5 phong 1 } }
sphere { 1.1*x, 1 texture { pigment { granite } }
    texture { pigment { rgbt <1, 0, 0, .5> } normal { bumps 2 scale .1 }
        finish { specular 1 } } }
plane { y, -1 pigment { rgb .7 }
    normal { checker normal { bumps 1 } normal { ripples 1 scale .2 } } }

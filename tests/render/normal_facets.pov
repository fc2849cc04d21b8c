// facets of a size, of the usual one, scaled; of cells of space.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> look_at 0 angle 40 }
light_source { <-5, 8, -6>, 1 }
#default { pigment { rgb <.9, .6, .3> } finish { ambient .1 phong .4 } }
sphere { <-1, 0, 0>, 1 normal { facets size .3 bump_size 3 } }
sphere { <1, 0, 0>, 1 normal { facets scale .3 } }
sphere { <-1, -2, 0>, 1 normal { facets coords .7 } }
sphere { <1, -2, 0>, 1 normal { facets coords 1 size .4 scale <1, 2, 1> } }

// height_field: every grey byte, of a PNG, which some are rounded down in, and
// of a PGM.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <.5, 2, .5> look_at <.5, 0, .5> right x up y }
#default {
    pigment { gradient y color_map { [0 rgb x] [1 rgb y] } scale 2/255 }
    finish { ambient 1 diffuse 0 }
}
height_field { png "parts/greys.png" scale <1, 1, .45> }
height_field { pgm "parts/greys.pgm" scale <1, 1, .45> translate .55*z }

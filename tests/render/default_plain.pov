// #default: pigments of the sky, of functions and of patterns don't start from
// it, those in their maps do.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at <0, 1, 0> }
light_source { <-5, 8, -5> 1 }
#default { pigment { marble turbulence .8 scale .6 color_map { [0 rgb 1] [1 rgb x] } } }
sky_sphere {
    pigment { gradient y color_map { [0 rgb 1] [1 rgb z] } }
    pigment { gradient x pigment_map { [.4 rgbt 1] [.6 wood] } }
}
#declare F = function { pigment { gradient y color_map { [0 rgb 1] [1 rgb z] } } };
#declare Colours = color_map { [0 rgb y] [1 rgb 0] }
sphere { <-2, 1, 0>, 1 pigment { function { F(x, y, z).x } color_map { Colours } } }
sphere {
    <0, 1, 0>, 1
    pigment {
        pigment_pattern { gradient y color_map { [0 rgb 1] [1 rgb 0] } }
        color_map { Colours }
    }
}
height_field {
    function 20, 20 { pigment { gradient y color_map { [0 rgb 0] [1 rgb 1] } } }
    translate <.5, 0, -.5> scale 2
}

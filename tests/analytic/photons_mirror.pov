// Photons that glass turns by total reflection, and colours on all of their
// way: parallel light into one side of a prism and out of the other.
// claims: rays mesh path
//
// Glass of ior 1.5 mirrors all that comes at 45 degrees. What enters x from the
// long side's end goes x to the mirror and 2 - x from there, always 2 units, of
// which exp((c - 1) 2) is left: of .8 through <.2, .5, .8>, <.16152, .29430,
// .53626>. A plate keeps all other light away.
#version 3.7;
global_settings { assumed_gamma 1 photons { spacing .01 } }
camera { orthographic location <-4.5, .05, .05> direction -x
    right 6.4*z up 4.8*y }
light_source { -20*z, rgb .8 parallel point_at 0 photons { refraction on } }
#default { finish { ambient 0 diffuse 1 } }
plane { x, -5 pigment { rgb 1 } }
difference {
    box { <-40, -40, -2>, <40, 40, -1.9> }
    box { <-.75, -1, -3>, <.75, 1, 2> }
    pigment { rgb 0 }
}
intersection {
    box { <-1, -1.5, -1>, <1, 1.5, 1> }
    plane { x, 0 rotate -45*y }
    pigment { rgbf 1 } finish { diffuse 0 }
    interior { ior 1.5
        fade_distance 1 fade_power 1001 fade_color <.2, .5, .8> }
    photons { target refraction on }
}

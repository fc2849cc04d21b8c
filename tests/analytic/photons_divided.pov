// Photons through a prism that divides light, but hardly bends its colours apart:
// photons_prism, sixteen colours of it, for each of which there are as many as
// of white light. Fewer would blur the edge of what is lit, at x = -.272.
// claims: rays
#version 3.7;
global_settings { assumed_gamma 1 photons { spacing .04 } }
camera { orthographic location <-.05, .05, 4> right 6.4*x up 4.8*y }
light_source { -20*z, rgb .8 parallel point_at 0 photons { refraction on } }
#default { finish { ambient 0 diffuse 1 } }
plane { -z, -10 pigment { rgb 1 } }
difference {
    box { <-40, -40, -1>, <40, 40, -.9> }
    box { <-2, -1, -2>, <-1, 1, 2> }
    pigment { rgb 0 }
}
intersection {
    box { <-2, -1, 0>, <-1, 1, 3> }
    plane { z, 0 rotate -20*y translate <-2, 0, 1> }
    pigment { rgbf 1 } interior { ior 1.5 dispersion 1.0001 dispersion_samples 16 } finish { diffuse 0 }
    photons { target refraction on }
}

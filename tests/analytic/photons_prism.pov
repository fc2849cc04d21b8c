// Photons through a prism: parallel light, a flat side of the prism towards it
// and one turned by a = 20 degrees behind, of ior 1.5.
// claims: rays mesh path
//
// sin(b) = 1.5 sin(a), b = 30.866 degrees: bent by d = b - a = 10.866 degrees,
// dx/dz = tan(d) = .19195. Light that leaves the prism at x falls on the wall
// at x + (10 - 1 - (x + 2) tan(a)) tan(d): the width that enters becomes
// 1 - tan(a) tan(d) = .93014 of it, and irradiance 1/.93014. Of .8: .86009, at
// x from -.272 to .658. A plate keeps all other light away.
#version 3.7;
global_settings { assumed_gamma 1 photons { spacing .01 } }
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
    pigment { rgbf 1 } interior { ior 1.5 } finish { diffuse 0 }
    photons { target refraction on }
}

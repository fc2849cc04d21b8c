// What collects no photons is lit straight through glass that bends light, in
// both lightings.
// claims: rays mesh
//
// Clear glass stands before the right half of a wall: right of it half the
// lamp's light arrives as on the left, .5.
#version 3.7;
global_settings { assumed_gamma 1 ambient_light 0 photons { count 2000 } }
camera { orthographic location <-.05, .05, -10> right 6.4*x up 4.8*y }
light_source { -100 * z, rgb .5 parallel point_at 0
    photons { refraction on reflection off } }
plane { -z, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 }
    photons { collect off } }
box { <0, -9, -2>, <9, 9, -1> pigment { rgbt 1 } finish { diffuse 0 }
    interior { ior 1.5 } photons { target refraction on reflection off } }

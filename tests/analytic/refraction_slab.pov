// A slab of glass, ior 1.5, 1 thick, at 45 degrees: it moves the ray aside by
// sin(i - t)/cos t, and leaves its direction.
// claims: rays path mesh soft
//
// sin t = sin 45/1.5 = .471405, cos t = .881917, sin(45 - t) = .290273; the
// shift is .329140 along +x (the slab's front normal is (-1, 0, -1)/sqrt 2, so
// the ray bends towards +x). Behind it a wall glows red from 0 at x = -4 to 1
// at x = 4: (x + .329140 + 4)/8. Above y = 1 there is no slab: (x + 4)/8.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <-.05, .05, -10> right 6.4*x up 4.8*y }
plane { -z, -9 pigment { gradient x color_map { [0 rgb 0] [1 rgb x] }
    scale 8 translate -4*x } finish { ambient 0 diffuse 0 emission 1 } }
box { <-7, -9, -.5>, <7, 1, .5> rotate 45*y
    pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { ior 1.5 } }

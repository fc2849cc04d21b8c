// A smooth triangle takes its normal from its corners, weighted linearly and
// then normalised, and that normal decides about light.
// claims: rays path mesh soft
//
// Corners (-2, -2), (2, -2), (0, 2) with normals <-.6, 0, -.8>, <.6, 0, -.8>,
// <0, .6, -.8>; a parallel light along the view; diffuse 1.
//   (0, 0): weights .25, .25, .5: <0, .3, -.8>: .8/sqrt .73 = .936329
//   (-1, -1): weights .625, .125, .25: <-.3, .15, -.8>: .8/sqrt .7525 = .922224
//   (.5, -1): weights .25, .5, .25: <.15, .15, -.8>: .8/sqrt .685 = .966595
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <-.05, .05, -10> right 6.4*x up 4.8*y }
light_source { <0, 0, -20>, rgb 1 parallel point_at 0 }
smooth_triangle {
    <-2, -2, 0>, <-.6, 0, -.8>, <2, -2, 0>, <.6, 0, -.8>,
    <0, 2, 0>, <0, .6, -.8>
    pigment { rgb 1 } finish { ambient 0 diffuse 1 }
}

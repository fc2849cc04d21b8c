// isosurface: evaluate finds the gradient, which is more than it begins with.
// (POV-Ray finds it while it draws, which loses parts of many another surface.)
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -6> look_at 0 angle 40 }
light_source { <-6, 9, -9>, 1 }
background { rgb .2 }
isosurface {
    function { 8 * (sqrt(x*x + y*y + z*z) - 1) }
    contained_by { box { -1.4, 1.4 } }
    evaluate 1, 1.2, .99
    pigment { rgb x }
    translate -1.3*x
}

// Bumps that +Q leaves out bend no fake caustics either.
// compare: exact
// options: -A +Q7
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 6, -15> look_at <0, 2, 0> angle 60 }
light_source { <0, 50, 0> rgb 1 }
plane { y, 0 pigment { rgb 0.6 } finish { diffuse 0.7 } }
plane {
    y, 10
    hollow on
    pigment { rgbf <0.7, 0.7, 1, 0.9> }
    normal { bumps 0.5 }
    interior { ior 1.1 caustics 1 }
}

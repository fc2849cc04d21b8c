// Parametric surfaces: one cut off by a box, one by a ball, with the surface's
// own coordinates, one upside down.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> look_at 0 angle 40 }
light_source { <-5, 8, -6>, 1 }
parametric {
    function { u } function { u * u + v * v * 0.5 } function { v }
    <-1, -1>, <1, 1>
    contained_by { box { <-1, 0, -0.8>, <0.8, 0.7, 1> } }
    max_gradient 2.5 accuracy 0.0005
    texture { pigment { uv_mapping checker rgb x rgb 1 scale 0.3 } }
    translate -1.1 * x
}
parametric {
    function { u * 0.8 } function { 0.4 * sin(3 * u) } function { v * 0.8 }
    <1, 1>, <-1, -1>
    contained_by { sphere { 0, 0.9 } }
    max_gradient 2 accuracy 0.0005
    precompute 12 x, y, z
    pigment { rgb <.3, .6, .9> } finish { phong .5 }
    rotate -20 * x translate 1.1 * x
}

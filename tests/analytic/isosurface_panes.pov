// Light through an isosurface that lets 0.8 of it pass: it crosses all eight
// surfaces, two of them the container's, though max_trace is 1 (as in POV-Ray):
// 0.8 to the eighth is 0.1678.
// claims: rays mesh
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, 4> look_at <0, 0, 10> right 4*x up 3*y }
light_source { <0, 0, -1000> rgb 1 parallel point_at 0 }
plane { -z, -15 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
isosurface {
    function { cos(z*pi) }
    contained_by { box { <-1, -1, -3>, <1, 1, 3> } }
    max_gradient 3.2
    pigment { rgbt <1, 1, 1, 0.8> }
}

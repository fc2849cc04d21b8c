// A smooth height field of steps as high as the field: a face is blended
// between the normals of the grid also where the three at its corners agree.
// compare: exact
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4, -5> look_at <0, 0.5, 0> angle 40 }
light_source { <-5, 8, -6> rgb 1 }
light_source { <5, 4, -6> rgb 0.4 }
height_field {
  function 32, 32 { pigment { checker rgb 1 rgb 0 scale 1/4 } }
  smooth
  translate <-0.5, 0, -0.5> scale <3, 0.5, 3>
  pigment { rgb 1 }
}

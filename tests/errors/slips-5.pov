// Coverings whose '}' is missing before what stands beside them.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5 * z look_at 0 }
sphere { 0, 1
  texture { pigment { rgb 1 }
  interior { ior 1.5 }
}
sphere { 0, 1 texture { pigment { rgb 1 } texture { pigment { rgbt 1 } } }

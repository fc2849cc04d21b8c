global_settings {
  light_mesh { density 3
}
sphere { 0, 1 pigment { rgb 1 }
light_source { 5, 1 }

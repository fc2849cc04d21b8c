// A '}' too few, and textures that are the layers of one.
#declare Rows = array[2][2] { { 1, 2 }, { 3, 4 };
#declare Looks = array[2] {
  texture { pigment { rgb 1 } }
  texture { pigment { rgb 0 } }
}

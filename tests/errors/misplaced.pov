#version 3.7;
sphere { 0, 1 pigment { image_map { png 'a.png' } } }
sphere { 0, 1 phong 1 }
sphere { 0, 1 rgb 1 }
#declare Shiny = finish { phong 1 }
sphere { 0, 1 Shiny }
sphere { 0, 1 };
fog { color rgb 1 }

box { 1, <0, 0, 0>, <1, 1, 1> }
cone { <0, 0, 0>, <0, 1, 0>, 1, 0 }
plane { 0, y }
sphere { center <0, 0, 0> radius 1 }
sphere { <0, 0, 0> radius 1 }
sphere { 0 -1 pigment { rgb 1 } }
sphere { 0, 1 translate <1, 2, 3 }
sphere { 0, 1 pigment { color red } }
sphere { 0, 1 pigment { #ff8000 } }
sphere { 0, 1 pigment { color_map { [0 rgb 0] } gradient y } }
sphere { 0, 1 pigment { wood color_map { 0 rgb 0 } } }
light_source { 5, rgb 1 spotlight on }
light_source { rgb 1 <0, 5, 0> }
light_source { <0, 5, 0> intensity 2 }
difference { sphere { 0, 1 } box { 0, 1 }; }
union { pigment { rgb 1 } sphere { 0, 1 } }
sphere { 0, 2 x }
#declare A = array { 1, 2 };
isosurface { function { x } pigment { rgb 1 } contained_by { box { -1, 1 } } }
text { ttf "arial.ttf" "Hi" 1, 0 }

isosurface { contained_by { box { -1, 1 } } }
isosurface { function { x } contained_by { cylinder { 0, y, 1 } } }
isosurface { function { x } accuracy 0 }
isosurface { function { x } max_gradient -1 }
isosurface { function { x } contained_by { sphere { 0, 0 } } }
isosurface { function(a) { a } }
isosurface { function { pigment { wood } } }
isosurface { function { x } treshold 1 }
sphere { 0, 1 pigment { function(a, b) { a } } }
sphere { 0, 1 pigment { object { disc { 0, z, 1 } rgb 1 rgb 0 } } }
sphere { 0, 1 pigment { function { pigment { wood } } } }
#declare P = function { pigment { wood } };
sphere { 0, 1 pigment { function { P(x, y, z) } } }
sphere { 0, 1 pigment { function { P(x, y, z).size } } }
#declare Q = function { pattern { scale 2 } };

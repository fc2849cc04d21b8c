sphere {
  0, 1
  pigment { rgb 1
  finish { phong 1 }
}
sphere { 0, 1 pigment { rgb 1 finish { phong 1 } } }
union {
  sphere { 0, 1
  sphere { x, 1 }
}
sphere { 0, 1 pigmnt { rgb 1 } }

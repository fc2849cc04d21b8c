// Values as in other languages: with '=' or ':' before them.
sphere { 0, 1
  pigment { color: red 1 }
}
sphere { 0, 1
  interior { ior = 1.5 }
}
sphere { center = 0, radius = 1 }
camera { location = <0, 0, -5> }
#declare A = random(5);

#declare Shell = finish { subsurface { translucency 0.3 } }
sphere { 0, 1 }
sphere { 0, 1 finish { Shell } }

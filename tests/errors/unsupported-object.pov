sphere { 0, 1 finish { subsurface { translucency 1 } } }

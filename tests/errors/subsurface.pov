global_settings { subsurface { samples 1e9, 1 } mm_per_unit 0 }
global_settings { subsurface { sample 1, 1 } }
sphere { 0, 1 finish { subsurface { translucent 1 } } }
sphere { 0, 1 finish { subsurface { translucency -1 } } }

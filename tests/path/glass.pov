// Glass with highlights, which reflects all light within itself: from one
// meeting to the next the light must not grow.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
#default { finish { ambient 0.1 diffuse 0.7 } }
camera { location <0, 1.5, -4> look_at <0, 0.3, 0> right 4/3*x angle 35 }
light_source { <-6, 8, -9>, rgb 1 }
plane { y, 0 pigment { rgb 0.6 } }
union {
  sphere { <-0.7, 0.5, 0>, 0.5 }
  sphere { <0.7, 0.5, 0>, 0.5 }
  pigment { rgbf 0.9 }
  finish { specular 0.6 reflection 0.1 }
  interior { ior 1.5 }
}

sphere { 0, 1 pigment { image_map { webp "a.webp" } } }
sphere { 0, 1 pigment { image_map { jpg "a.jpg" } } }
height_field { pmg "a.pgm" }

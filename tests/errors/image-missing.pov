plane { y, 0 pigment { image_map { png "no-such.png" } } }

sphere { 0, 1 pigment { image_map { png "C:\temp\new.png" } } }

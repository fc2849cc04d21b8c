#version 3.7;
sphere { 0, 1 pigment { image_map { function 0, 9 { x } } } }
sphere { 0, 1 pigment { image_map { function 60000, 60000 { x } } } }
sphere { 0, 1 pigment { image_map { png "../render/parts/flag.png"
    transmit 300, 1 } } }
sphere { 0, 1 pigment { image_map { png "../render/parts/flag.png"
    filter 3, 1 } } }
sphere { 0, 1 texture { gradient x texture_map { Unknown } } }

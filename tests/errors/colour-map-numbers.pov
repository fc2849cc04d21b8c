#version 3.7;
sphere { 0, 2 pigment { bozo color_map { [0 1, 0, 0] [1 0, 0, 1] } } }

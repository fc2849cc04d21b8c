#version 3.8;
sphere { 0, 1 }

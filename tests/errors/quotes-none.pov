#version 3.7;
#include camera-context.inc
#include sphere.inc
sphere { 0, 1 pigment { image_map { png sphere.png } } }

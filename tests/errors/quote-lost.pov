#version 3.7;
#include colors.inc"
#include "textures.inc"
sphere { 0, 1 }

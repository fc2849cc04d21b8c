#version 4;

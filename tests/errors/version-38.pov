#version 3.8;
wrong

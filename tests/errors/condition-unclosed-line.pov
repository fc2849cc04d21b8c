#version 3.7;
#if (clock > 0.5
  sphere { 0, 1 }
#end

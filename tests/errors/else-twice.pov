#version 3.7;
global_settings { assumed_gamma 1 }
#if (0)
  sphere { 0, 1 }
#else
  box { 0, 1 }
#else
  sphere { 0, 2 }
#end
#if (0)
#else
#elseif (1)
  sphere { 0, 2 }
#end
#if (1)
#else
#else // POV-Ray, too, doesn't look at what it skips
#end

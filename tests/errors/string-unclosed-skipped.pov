#ifdef (Never)
  Write(points", 5)
#end
sphere { 0, 1 }
#declare S = "text";

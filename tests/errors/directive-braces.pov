// Braces instead of #end.
#if (1) {
  sphere { 0, 1 }
}
#end

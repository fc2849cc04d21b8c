// A name of three words, lamps whose braces are missing, a ')' that is.
#declare My Red Ball = sphere { 0, 1 };
light_source
#declare Radius = 2;
sphere { 0, Radius }
#include ""

#while (÷1#include "shapes.inc" ! #end

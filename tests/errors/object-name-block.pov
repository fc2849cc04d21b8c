#declare Ball = sphere { 0, 1 }
#declare Stone = texture { pigment { rgb 1 } }
Ball { translate x }
union { object { Ball } Ball { translate y } }
object Ball
sphere { 0, 1 texture Stone }
sphere { 0, 1 pigment rgb 1 }
sphere ( 0, 1 )
#include "colors.inc"
sphere { 0, 1 pigment Red }

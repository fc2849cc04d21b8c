/* What those type who know other programs. */
#macro Ball(R) {
  sphere { 0, R }
} #end
Ball(1)
#macro Ball(R) return sphere { 0, R } #end
object { Ball(1) }
light_source { 0 5 -5 color rgb 1 }
sphere { 0, 1 bumps 0.5 }
sphere { 0, 1 texture { "Wood" } }
sphere { 0, 1 finish { reflection metallic } }
sphere { <0， 1, 0>, 1 }
#if (1 > 0) then sphere { 0, 1 } #end
#if (1 > 0) && (2 > 1) sphere { 0, 1 } #end
sphere { 0, 1 }
#for (I, 0, 2) #begin #end
#for (int i = 0; i < 3; i++) #end
#macro Typed(int A) #end
#declare F = function(float x) { x };
sphere { 0, 1 }
<!-- a comment -->
sphere { 0, 1 }
#declare MyBall = sphere { 0, 1 }
myball { translate x }

#declare Link = union {
  torus { 1, 0.2 }
  difference { torus { 1, 0.2 } box { -1, 1 } translate y
}
#macro Chain(N)
  #for (I, 0, N - 1) object { Link translate x*I } #end
#end
object { Chain(3) }

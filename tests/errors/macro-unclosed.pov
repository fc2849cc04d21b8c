// The macro is known by name, nothing more is said of it.
#macro Brick(Width, Length, Colour
union {
    box { 0, <Width, 1, Length> }
    pigment { Colour }
}
#end
object { Brick(1, 2, rgb 1) }

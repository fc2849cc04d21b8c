#macro Tower(R)
  sphere { <0,0,0>, R pigment { rgb Colour } }
#end
#macro City(N)
  Tower(N)
#end
City(3)

height_field { png "../render/parts/height8.png" }
height_field { pot "terrain.pot" }
height_field { png "../render/parts/dot.png" }
height_field { png "../render/parts/heights8.png" smoth }
height_field { function 1, 10 { x } }
height_field { function 20000, 20000 { x } }
height_field { function 9000, 9000 { (x + y)*(x - y)*x*y + x*x*y - y*y*x } }
height_field { function { x } }
height_field { pot "../render/parts/heights8.png" }

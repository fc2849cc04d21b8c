height_field { png "../render/parts/height8.png" }
height_field { pot "terrain.pot" }
height_field { png "../render/parts/dot.png" }
height_field { png "../render/parts/heights8.png" smoth }
height_field { function 1, 10 { x } }
height_field { function 20000, 20000 { x } }
height_field { function 4000, 4000 { sum(i, 0, 1000, x + i) } }
height_field { function { x } }

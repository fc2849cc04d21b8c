height_field { png "../render/parts/height8.png" }
height_field { pot "terrain.pot" }
height_field { png "../render/parts/dot.png" }
height_field { png "../render/parts/heights8.png" smoth }
height_field { function 10, 10 { x } }

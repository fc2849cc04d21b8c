text { ttf "timrom.ttf" "Hi" 1 }
light_source { y rgb 1 area_light 4 4 }
#debug concat("a", 3)

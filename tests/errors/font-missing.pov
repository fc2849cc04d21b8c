text { ttf "no-such.ttf" "A" 1, 0 }

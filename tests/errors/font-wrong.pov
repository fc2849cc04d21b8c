text { ttf "font-wrong.pov" "A" 1, 0 }
text { internal 4 "A" 1, 0 }
text { "timrom.ttf" "A" 1, 0 }

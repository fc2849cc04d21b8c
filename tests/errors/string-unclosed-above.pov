#declare T = text { ttf "timrom.ttf" "glim .4, 0 }
#debug concat("width ", str(1, 0, 3), "\n")

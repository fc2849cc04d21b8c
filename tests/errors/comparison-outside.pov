#declare A = str(2 > 1, 0, 0)

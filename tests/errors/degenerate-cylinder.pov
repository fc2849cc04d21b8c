cylinder { y, y, 1 }

#write (F, "x")

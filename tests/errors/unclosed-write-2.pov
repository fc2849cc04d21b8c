#write (
sphere { 0, 1 }

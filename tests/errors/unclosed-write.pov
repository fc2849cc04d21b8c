// The ')' of a #write is missing.
#fopen File "unclosed-write.txt" write
#write (File, "a",
sphere { 0, 1 }

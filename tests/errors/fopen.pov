#declare N = 1;
#fopen N "out.txt" read
#fopen F "out.txt" reed
#fopen Out "out.txt" write
#fopen Out "out.txt" write
#write (Ouch, 1)
#read (Out, A)
#write (Out, x, )
#fclose N
#fopen In "fopen.txt" read
#write (In, 1)
#declare Many = array[2];
#read (In, Many)
#read (In, Bytes, Out)
#fopen Raw "raw" write
#write (Raw, sint8 1)
#fclose Raw
#fopen Raw "raw" read

#fopen F "fopen-data.txt" read
#while (defined(F)) #read (F, A) #end

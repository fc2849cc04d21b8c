#fopen F "out.txt" write

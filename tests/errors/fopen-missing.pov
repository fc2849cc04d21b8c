#fopen F "fopen.text" read

#declare A = array[100000][100000];

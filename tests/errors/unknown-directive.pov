#decalre A = 1;

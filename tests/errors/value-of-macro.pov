#include "rand.inc"
#declare Stream = seed(1);
#declare A = RRand(1, 2, Stream)
#declare B = 2 * RRand(1, 2, Stream)
#declare C = <1, 2, 3>
sphere { C, A + B }

/* Eight doubles at a time. A processor without such wide instructions does them
 * in parts: functions of them are CLONES, and hand them on by pointers, since
 * how they are handed on by value differs between processors. */
#ifndef BASE_OCTET_H
#define BASE_OCTET_H

#include <stdint.h>

enum { OCTET = 8 };

typedef double octet __attribute__((vector_size(OCTET * sizeof(double))));

/* What comparing two of them gives: all bits set where it is so. */
typedef int64_t octet_bits
    __attribute__((vector_size(OCTET * sizeof(int64_t))));

#endif

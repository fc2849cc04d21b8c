/* Numbers in order, for qsort. */
#ifndef BASE_ORDER_H
#define BASE_ORDER_H

/* Doubles, the least first. */
static inline int order_double(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

#endif

/* Libraries that are loaded when they are needed. */
#ifndef BASE_LIBRARY_H
#define BASE_LIBRARY_H

#include <stddef.h>

/* The library, which stays loaded, or NULL with the reason. It is not even
 * tried where `ulimit -v` leaves less than the `mebibytes` that it takes: what
 * is written in C++ is at a loss without memory. */
void *library_open(const char *name, size_t mebibytes, char *error,
                   size_t size);

#endif

/* Hashes of data of any kind, to tell whether it is what it was. Not made to
 * withstand somebody who wants two to be equal. */
#ifndef BASE_HASH_H
#define BASE_HASH_H

#include <stddef.h>
#include <stdint.h>

#include "base/field.h"

/* `hash` with more data in it: bytes; numbers, of which -0 is not 0; a text,
 * NULL being none. */
uint64_t hash_bytes(uint64_t hash, const void *bytes, size_t count);
uint64_t hash_numbers(uint64_t hash, const double *numbers, size_t count);
uint64_t hash_text(uint64_t hash, const char *text);

/* The values of all fields of a table, NULL being none, in the struct. */
uint64_t hash_fields(uint64_t hash, const struct field *table,
                     const void *values);

#endif

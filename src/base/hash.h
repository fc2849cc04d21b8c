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

/* Of a struct that several tables describe, ending with NULL: first all single
 * numbers in one row, then each vector and colour. Fields that light doesn't
 * depend on are left out; the tables have HASH_ROW numbers at most. */
enum { HASH_ROW = 64 };
uint64_t hash_tables(uint64_t hash, const struct field *const *tables,
                     const void *values);

/* Only the ones of a table, or the others, in the same way. */
uint64_t hash_narrow(uint64_t hash, const struct field *const *tables,
                     const void *values);
uint64_t hash_wide(uint64_t hash, const struct field *table,
                   const void *values);

#endif

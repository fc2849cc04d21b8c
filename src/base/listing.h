/* Kinds of a thing, listed by the X-macro of a list.h: LISTING(name, type,
 * items) defines
 *
 *   const struct TYPE *NAME_at(size_t index)       NULL past the end
 *   const struct TYPE *NAME_find(const char *)     by its `name`, or NULL
 *
 * for `items`, an array of pointers to them. */
#ifndef BASE_LISTING_H
#define BASE_LISTING_H

#include <stddef.h>
#include <string.h>

#define LISTING(listing, type, items)                                          \
    const struct type *listing##_at(size_t index)                              \
    {                                                                          \
        return index < sizeof(items) / sizeof *(items) ? (items)[index]        \
                                                       : NULL;                 \
    }                                                                          \
    const struct type *listing##_find(const char *wanted)                      \
    {                                                                          \
        for (size_t i = 0; i < sizeof(items) / sizeof *(items); i++)           \
            if (strcmp((items)[i]->name, wanted) == 0)                         \
                return (items)[i];                                             \
        return NULL;                                                           \
    }                                                                          \
    struct type

#endif

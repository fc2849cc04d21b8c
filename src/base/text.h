/* Small helpers on C strings that several layers need. */
#ifndef BASE_TEXT_H
#define BASE_TEXT_H

#include <stdbool.h>
#include <stddef.h>

/* Edit distance with transpositions (optimal string alignment), case ignored;
 * words over 64 bytes count as wholly different. */
unsigned text_distance(const char *a, const char *b);

/* For "did you mean": keeps the candidate nearest to `word`. Start with
 * best = NULL, best_distance = a limit (text_distance_limit). */
struct text_nearest {
    const char *word;
    const char *best;
    unsigned best_distance;
};
struct text_nearest text_nearest_start(const char *word);
void text_nearest_try(struct text_nearest *nearest, const char *candidate);

/* Case-insensitive equality of ASCII. */
bool text_equal_nocase(const char *a, const char *b);

/* FNV-1a, for hash tables and for checksums of configuration. */
unsigned long long text_hash(const char *text, size_t length);

#endif

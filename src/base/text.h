/* Small helpers on C strings that several layers need. */
#ifndef BASE_TEXT_H
#define BASE_TEXT_H

#include <stdbool.h>
#include <stddef.h>

/* Edit distance with transpositions (optimal string alignment), case ignored;
 * words over 64 bytes count as wholly different. */
unsigned text_distance(const char *a, const char *b);

/* For "did you mean": keeps the candidate nearest to `word`; of several as near
 * the first that begins like it, since few mistype the first letter. */
struct text_nearest {
    const char *word;
    const char *best;
    unsigned best_distance;
};
struct text_nearest text_nearest_start(const char *word);
void text_nearest_try(struct text_nearest *nearest, const char *candidate);

/* Case-insensitive equality of ASCII. */
bool text_equal_nocase(const char *a, const char *b);

/* What comes after the last '/' of a file's name. */
const char *text_last_part(const char *name);

/* Whether it is one of the words, which have a blank between them; case of
 * ASCII ignored. */
bool text_among(const char *word, const char *words);

/* A number as people write it, up to 10 digits: 1000000 and 0.000001 rather
 * than 1e+06 and 1e-06; beyond 1e15 and below 1e-9 with an exponent. Returns
 * `text`. NUMBER_TEXT does it in the block it stands in. */
enum { TEXT_NUMBER_SIZE = 32 };
const char *text_number(char text[TEXT_NUMBER_SIZE], double number);
#define NUMBER_TEXT(number)                                                    \
    text_number((char[TEXT_NUMBER_SIZE]){ "" }, (number))

/* FNV-1a, for hash tables and for checksums of configuration. */
unsigned long long text_hash(const char *text, size_t length);

#endif

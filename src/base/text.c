/* String helpers: see text.h. */
#include "base/text.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { LONGEST = 64 };

static int lower(char c)
{
    return c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : (unsigned char)c;
}

static unsigned least(unsigned a, unsigned b)
{
    return a < b ? a : b;
}

unsigned text_distance(const char *a, const char *b)
{
    size_t m = strlen(a), n = strlen(b);
    if (m > LONGEST || n > LONGEST)
        return m > n ? (unsigned)m : (unsigned)n;
    unsigned rows[3][LONGEST + 1];
    unsigned *before = rows[0], *previous = rows[1], *current = rows[2];
    for (size_t j = 0; j <= n; j++)
        previous[j] = (unsigned)j;
    for (size_t i = 1; i <= m; i++) {
        current[0] = (unsigned)i;
        for (size_t j = 1; j <= n; j++) {
            bool same = lower(a[i - 1]) == lower(b[j - 1]);
            unsigned best = least(previous[j], current[j - 1]) + 1;
            best = least(best, previous[j - 1] + !same);
            if (i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) &&
                lower(a[i - 2]) == lower(b[j - 1]))
                best = least(best, before[j - 2] + 1);
            current[j] = best;
        }
        unsigned *free_row = before;
        before = previous;
        previous = current;
        current = free_row;
    }
    return previous[n];
}

struct text_nearest text_nearest_start(const char *word)
{
    size_t length = strlen(word);
    unsigned limit = length <= 4 ? 1 : length <= 8 ? 2 : 3;
    return (struct text_nearest){ word, NULL, limit + 1 };
}

static bool text_begins_like(const char *a, const char *b)
{
    return lower(*a) == lower(*b);
}

/* Whether the candidate goes on where the word ends: with an underscore, or
 * anyhow where the word is long. */
static bool text_goes_on(const char *word, const char *candidate)
{
    size_t length = strlen(word);
    return length > 3 && strncmp(word, candidate, length) == 0 &&
           candidate[length] && (length > 5 || candidate[length] == '_');
}

/* Lengths that differ by more than the best distance can't be nearer: this
 * spares nearly all of the 500 reserved words. */
void text_nearest_try(struct text_nearest *nearest, const char *candidate)
{
    size_t length = strlen(nearest->word), other = strlen(candidate);
    size_t apart = length > other ? length - other : other - length;
    /* One that is as near may still be better. */
    bool equal_counts = nearest->best &&
                        !text_begins_like(nearest->best, nearest->word) &&
                        text_begins_like(candidate, nearest->word);
    unsigned limit = nearest->best_distance + equal_counts;
    bool goes_on = text_goes_on(nearest->word, candidate);
    if (apart >= limit && !goes_on)
        return;
    unsigned distance = goes_on ? 1 : text_distance(nearest->word, candidate);
    if (distance < limit && distance < length) {
        nearest->best = candidate;
        nearest->best_distance = distance;
    }
}

const char *text_number(char text[TEXT_NUMBER_SIZE], double number)
{
    double size = fabs(number);
    snprintf(text, TEXT_NUMBER_SIZE, "%.10g", number);
    if (!strchr(text, 'e') || !(size >= 1e-9 && size < 1e15))
        return text;
    int decimals = size < 1 ? 9 - (int)floor(log10(size)) : 0;
    snprintf(text, TEXT_NUMBER_SIZE, "%.*f", decimals, number);
    for (size_t last = strlen(text) - 1; decimals && text[last] == '0'; last--)
        text[last] = '\0';
    return text;
}

bool text_equal_nocase(const char *a, const char *b)
{
    while (*a && lower(*a) == lower(*b))
        a++, b++;
    return lower(*a) == lower(*b);
}

bool text_among(const char *word, const char *words)
{
    for (; *words; words += strspn(words, " ")) {
        size_t length = strcspn(words, " "), i = 0;
        while (i < length && lower(word[i]) == lower(words[i]))
            i++;
        if (i == length && !word[i])
            return true;
        words += length;
    }
    return false;
}

unsigned long long text_hash(const char *text, size_t length)
{
    unsigned long long hash = 14695981039346656037ull;
    for (size_t i = 0; i < length; i++)
        hash = (hash ^ (unsigned char)text[i]) * 1099511628211ull;
    return hash;
}

const char *text_last_part(const char *name)
{
    const char *slash = strrchr(name, '/');
    return slash ? slash + 1 : name;
}

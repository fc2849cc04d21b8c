/* Long plain lists: see numbers.h. */
#include "token/numbers.h"

#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>

#include "base/array.h"

enum { SHORTEST_VECTOR = 7 }; /* <0,0,0> */

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

/* Exact for up to 15 digits and small exponents: both operands are then exact
 * doubles and one division rounds once (Clinger 1990). strtod for the rest. */
static double number_value(const char *start, const char *end)
{
    static const double powers[] = { 1e0,  1e1,  1e2,  1e3,  1e4,  1e5,
                                     1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                     1e12, 1e13, 1e14, 1e15, 1e16, 1e17,
                                     1e18, 1e19, 1e20, 1e21, 1e22 };
    uint64_t mantissa = 0;
    unsigned digits = 0, decimals = 0;
    bool point = false;
    const char *p = start;
    for (; p < end && (is_digit(*p) || *p == '.'); p++) {
        if (*p == '.') {
            point = true;
            continue;
        }
        mantissa = mantissa * 10 + (uint64_t)(*p - '0');
        decimals += point;
        if (++digits > 15)
            break;
    }
    if (p == end && decimals <= 22)
        return (double)mantissa / powers[decimals];
    return strtod(start, NULL);
}

/* number = (digit {digit} ["." {digit}] | "." digit {digit}) [exponent] .
 * exponent = ("e" | "E") ["+" | "-"] digit {digit} . */
double number_read(const char *text, const char **end)
{
    const char *p = text;
    while (is_digit(*p))
        p++;
    if (*p == '.' && (p > text || is_digit(p[1]))) {
        p++;
        while (is_digit(*p))
            p++;
    }
    if (p > text && (*p == 'e' || *p == 'E')) {
        const char *q = p + 1;
        q += *q == '+' || *q == '-';
        if (is_digit(*q)) {
            while (is_digit(*q))
                q++;
            p = q;
        }
    }
    *end = p;
    return p > text ? number_value(text, p) : 0;
}

static const char *skip_space(const char *p)
{
    while (*p == ' ' || (*p >= '\t' && *p <= '\r'))
        p++;
    return p;
}

/* Takes the character and the space around it. */
static bool take(const char **at, char c)
{
    const char *p = skip_space(*at);
    if (*p != c)
        return false;
    *at = skip_space(p + 1);
    return true;
}

static bool take_number(const char **at, double *value)
{
    bool minus = **at == '-';
    const char *start = *at + minus, *end;
    *value = number_read(start, &end);
    *at = end;
    if (minus)
        *value = -*value;
    return end > start && *end != '.';
}

static bool take_vector(const char **at, double *v)
{
    return take(at, '<') && take_number(at, &v[0]) && take(at, ',') &&
           take_number(at, &v[1]) && take(at, ',') && take_number(at, &v[2]) &&
           take(at, '>');
}

const struct number_list *numbers_cut(struct arena *arena, const char *text,
                                      size_t size, size_t *length)
{
    struct {
        double (*items)[3];
        size_t count, capacity;
    } vectors = { 0 };
    const char *at = text;
    double said, v[3];
    if (!take(&at, '{') || !take_number(&at, &said) || !(said >= NUMBERS_LEAST))
        return NULL;
    take(&at, ',');
    size_t room = size / SHORTEST_VECTOR;
    ARRAY_RESERVE(arena, &vectors, said < (double)room ? (size_t)said : room);
    while (*at == '<' && take_vector(&at, v)) {
        double *out = *ARRAY_PUSH(arena, &vectors);
        for (int i = 0; i < 3; i++)
            out[i] = v[i];
        take(&at, ',');
        if (arena_over_limit(arena))
            return NULL;
    }
    if (*at != '}' || vectors.count < NUMBERS_LEAST)
        return NULL;
    struct number_list *list = ARENA_NEW(arena, struct number_list);
    list->said = said;
    list->count = vectors.count;
    list->vectors = vectors.items;
    *length = (size_t)(at + 1 - text);
    return list;
}

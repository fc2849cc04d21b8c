/* Long plain lists: see numbers.h. */
#include "token/numbers.h"

#include <stdlib.h>

#include "base/array.h"

enum { SHORTEST_VECTOR = 7 }; /* <0,0,0> */

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

/* Exact for up to 15 digits and small exponents: both operands are then exact
 * doubles and one division rounds once (Clinger 1990). */
static double number_exact(uint64_t mantissa, size_t decimals)
{
    static const double powers[] = { 1e0,  1e1,  1e2,  1e3, 1e4,  1e5,
                                     1e6,  1e7,  1e8,  1e9, 1e10, 1e11,
                                     1e12, 1e13, 1e14, 1e15 };
    return (double)mantissa / powers[decimals];
}

static const char *number_digits(const char *p, uint64_t *mantissa)
{
    for (; is_digit(*p); p++)
        *mantissa = *mantissa * 10 + (uint64_t)(*p - '0');
    return p;
}

/* The end of the exponent at p, or p if there is none. */
static const char *number_exponent(const char *p)
{
    const char *q = p + 1;
    if (*p != 'e' && *p != 'E')
        return p;
    q += *q == '+' || *q == '-';
    if (!is_digit(*q))
        return p;
    while (is_digit(*q))
        q++;
    return q;
}

/* number = (digit {digit} ["." {digit}] | "." digit {digit}) [exponent] .
 * exponent = ("e" | "E") ["+" | "-"] digit {digit} . */
double number_read(const char *text, const char **end)
{
    uint64_t mantissa = 0;
    const char *p = number_digits(text, &mantissa);
    size_t digits = (size_t)(p - text), decimals = 0;
    if (*p == '.' && (p > text || is_digit(p[1]))) {
        const char *point = p + 1;
        p = number_digits(point, &mantissa);
        decimals = (size_t)(p - point);
    }
    *end = p;
    if (p == text)
        return 0;
    *end = number_exponent(p);
    if (*end == p && digits + decimals <= 15)
        return number_exact(mantissa, decimals);
    return strtod(text, NULL);
}

const char *numbers_skip_space(const char *p)
{
    while (*p == ' ' || (*p >= '\t' && *p <= '\r'))
        p++;
    return p;
}

bool numbers_take(const char **at, char c)
{
    const char *p = numbers_skip_space(*at);
    if (*p != c)
        return false;
    *at = numbers_skip_space(p + 1);
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

bool numbers_take_vector(const char **at, double v[3])
{
    return numbers_take(at, '<') && take_number(at, &v[0]) &&
           numbers_take(at, ',') && take_number(at, &v[1]) &&
           numbers_take(at, ',') && take_number(at, &v[2]) &&
           numbers_take(at, '>');
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
    if (!numbers_take(&at, '{') || !take_number(&at, &said) ||
        !(said >= NUMBERS_LEAST))
        return NULL;
    numbers_take(&at, ',');
    size_t room = size / SHORTEST_VECTOR;
    ARRAY_RESERVE(arena, &vectors, said < (double)room ? (size_t)said : room);
    while (*at == '<' && numbers_take_vector(&at, v)) {
        double *out = *ARRAY_PUSH(arena, &vectors);
        for (int i = 0; i < 3; i++)
            out[i] = v[i];
        numbers_take(&at, ',');
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

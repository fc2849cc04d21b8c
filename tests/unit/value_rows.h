/* Tables of expressions and their values, and their comparison with what the
 * parser makes of them. */
#ifndef TESTS_UNIT_VALUE_ROWS_H
#define TESTS_UNIT_VALUE_ROWS_H

#include <math.h>

#include "scene_text.h"

struct row {
    const char *expression;
    const char *text; /* of a string */
    int count;        /* 1: a number, else a vector or colour */
    double values[5];
};

#define F(expression, value)                                                   \
    {                                                                          \
        expression, NULL, 1,                                                   \
        {                                                                      \
            value                                                              \
        }                                                                      \
    }
#define V(expression, ...)                                                     \
    {                                                                          \
        expression, NULL, 5,                                                   \
        {                                                                      \
            __VA_ARGS__                                                        \
        }                                                                      \
    }
#define S(expression, text)                                                    \
    {                                                                          \
        expression, text, 0,                                                   \
        {                                                                      \
            0                                                                  \
        }                                                                      \
    }

static inline bool near(double a, double b)
{
    return (isnan(a) && isnan(b)) || fabs(a - b) <= 6e-5 + 1e-9 * fabs(b);
}

static inline char *evaluate(const struct row *row)
{
    char declarations[300] = "", expression[300];
    if (row->count == 1)
        snprintf(expression, sizeof expression, "str(%s, 0, 10)",
                 row->expression);
    else if (row->count == 0)
        snprintf(expression, sizeof expression, "%s", row->expression);
    else
        snprintf(expression, sizeof expression, "vstr(5, K, \" \", 0, 10)");
    if (row->count == 5)
        snprintf(declarations, sizeof declarations, "#declare K = %s;",
                 row->expression);
    return scene_text_marked(declarations, expression);
}

static inline bool agrees(const struct row *row, const char *found)
{
    if (!found)
        return false;
    if (row->count == 0)
        return strcmp(found, row->text) == 0;
    for (int i = 0; i < row->count; i++) {
        char *end;
        if (!near(strtod(found, &end), row->values[i]))
            return false;
        found = end;
    }
    return true;
}

/* How many rows are not as the table says; each is printed. */
static inline unsigned count_wrong(const struct row *rows, size_t count)
{
    unsigned wrong = 0;
    for (size_t i = 0; i < count; i++) {
        char *found = evaluate(&rows[i]);
        if (!agrees(&rows[i], found)) {
            fprintf(stderr, "%s: found %s\n", rows[i].expression,
                    found ? found : "an error");
            wrong++;
        }
        free(found);
    }
    return wrong;
}

#endif

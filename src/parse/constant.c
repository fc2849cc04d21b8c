/* Words that are values: pi, x, clock, on ... */
#include "parse/expression.h"
#include "parse/function.h"

static bool constant_vector(enum keyword keyword, struct value *value)
{
    static const struct {
        enum keyword keyword;
        int size, axis;
    } rows[] = {
        { KEYWORD_X, 3, 0 }, { KEYWORD_Y, 3, 1 }, { KEYWORD_Z, 3, 2 },
        { KEYWORD_U, 2, 0 }, { KEYWORD_V, 2, 1 }, { KEYWORD_T, 4, 3 }
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        if (rows[i].keyword != keyword)
            continue;
        *value = (struct value){ .kind = VALUE_VECTOR, .size = rows[i].size };
        value->number[rows[i].axis] = 1;
        return true;
    }
    return false;
}

static bool constant_number(const struct parser *p, enum keyword keyword,
                            double *out)
{
    const struct parse_options *o = p->options;
    switch (keyword) {
    case KEYWORD_PI:
        *out = M_PI;
        return true;
    case KEYWORD_TRUE:
    case KEYWORD_YES:
    case KEYWORD_ON:
        *out = 1;
        return true;
    case KEYWORD_FALSE:
    case KEYWORD_NO:
    case KEYWORD_OFF:
        *out = 0;
        return true;
    case KEYWORD_CLOCK:
        *out = o->clock;
        return true;
    case KEYWORD_CLOCK_ON:
        *out = o->clock_on;
        return true;
    case KEYWORD_NOW:
        *out = text_days_now();
        return true;
    case KEYWORD_VERSION:
        *out = p->version;
        return true;
    default:
        return false;
    }
}

/* constant = "pi" | "true" | "yes" | "on" | "false" | "no" | "off" | "x" | "y"
 *          | "z" | "t" | "u" | "v" | "clock" | "clock_on" | "now"
 *          | "version" . */
bool parse_constant(struct parser *p, enum keyword keyword, struct value *value)
{
    if (constant_vector(keyword, value))
        return true;
    *value = value_float(0);
    return constant_number(p, keyword, &value->number[0]);
}

bool constant_is_number(struct parser *p, enum keyword keyword)
{
    double ignored;
    return constant_number(p, keyword, &ignored);
}

bool constant_is(struct parser *p, enum keyword keyword)
{
    struct value ignored;
    return parse_constant(p, keyword, &ignored);
}

/* The functions of expressions, sin() to vstr(): a row each, by keyword. */
#ifndef PARSE_FUNCTION_H
#define PARSE_FUNCTION_H

#include "parse/parser.h"

enum { CALL_ARGUMENTS = 5 }; /* the most a function takes: vstr() */

/* One call, its arguments read. */
struct call {
    struct span span; /* name to ")" */
    struct value arguments[CALL_ARGUMENTS];
    int count;
    const struct object *object; /* argument "o" */
    const struct array *array;   /* argument "a" */
    struct symbol *target;       /* argument "i" */
};

struct function_row {
    /* One letter for each argument: f float, v vector, n vector of any size,
     * s string, o object identifier, a array identifier, d any name (its
     * value is whether it is declared), i vector identifier that the function
     * gives a value. Arguments after '|' may be missing;
     * '+' repeats the one before it, and the function is applied to the first
     * two, then to the result and the third ... */
    const char *signature;
    /* Floats to a float: all that user functions need ... */
    double (*one)(double);
    double (*two)(double, double);
    /* ... else, or to check arguments first: sets *result, to poison after
     * reporting an error. */
    void (*run)(struct parser *p, const struct call *call,
                struct value *result);
};

/* The row of a function's name; NULL if it is none. */
const struct function_row *function_find(enum keyword keyword);

/* Whether the word is the name of a function, supported or not. */
bool function_is(enum keyword keyword);

/* What it gives: a float, vector or string; VALUE_NONE: it is no function. */
enum value_kind function_gives(enum keyword keyword);

/* Reads a call, the function's name being next; may give poison. */
bool parse_call(struct parser *p, struct value *value);

/* What is special: reports and makes *result poison. */
__attribute__((format(printf, 5, 6))) void
call_error(struct parser *p, const struct call *call, struct value *result,
           const char *hint, const char *format, ...);

/* function_number.c */
double number_int(double x);
double number_div(double a, double b);
double number_degrees(double x);
double number_radians(double x);
double number_mod(double a, double b);
double number_and(double a, double b);
double number_or(double a, double b);
double number_xor(double a, double b);
void number_sqrt(struct parser *, const struct call *, struct value *);
void number_ln(struct parser *, const struct call *, struct value *);
void number_log(struct parser *, const struct call *, struct value *);
void number_asin(struct parser *, const struct call *, struct value *);
void number_acos(struct parser *, const struct call *, struct value *);
void number_atan2(struct parser *, const struct call *, struct value *);
void number_pow(struct parser *, const struct call *, struct value *);
void number_select(struct parser *, const struct call *, struct value *);
void number_seed(struct parser *, const struct call *, struct value *);
void number_rand(struct parser *, const struct call *, struct value *);
void number_defined(struct parser *, const struct call *, struct value *);
void number_dimensions(struct parser *, const struct call *, struct value *);
void number_dimension_size(struct parser *, const struct call *,
                           struct value *);

/* function_vector.c */
void vector_inside(struct parser *, const struct call *, struct value *);
void vector_trace(struct parser *, const struct call *, struct value *);
void vector_dot(struct parser *, const struct call *, struct value *);
void vector_length(struct parser *, const struct call *, struct value *);
void vector_cross(struct parser *, const struct call *, struct value *);
void vector_normalise(struct parser *, const struct call *, struct value *);
void vector_rotate(struct parser *, const struct call *, struct value *);
void vector_axis_rotate(struct parser *, const struct call *, struct value *);
void vector_turbulence(struct parser *, const struct call *, struct value *);
void vector_min_extent(struct parser *, const struct call *, struct value *);
void vector_max_extent(struct parser *, const struct call *, struct value *);

/* function_text.c */
void text_asc(struct parser *, const struct call *, struct value *);
void text_chr(struct parser *, const struct call *, struct value *);
void text_concat(struct parser *, const struct call *, struct value *);
void text_file_exists(struct parser *, const struct call *, struct value *);
void text_str(struct parser *, const struct call *, struct value *);
void text_strcmp(struct parser *, const struct call *, struct value *);
void text_strlen(struct parser *, const struct call *, struct value *);
/* Days since the beginning of the year 2000, universal time. */
double text_days_now(void);
void text_datetime(struct parser *, const struct call *, struct value *);
void text_strlwr(struct parser *, const struct call *, struct value *);
void text_strupr(struct parser *, const struct call *, struct value *);
void text_substr(struct parser *, const struct call *, struct value *);
void text_val(struct parser *, const struct call *, struct value *);
void text_vstr(struct parser *, const struct call *, struct value *);

#endif

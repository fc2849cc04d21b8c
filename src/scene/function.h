/* What a user function is compiled to: steps of a stack machine on doubles. */
#ifndef SCENE_FUNCTION_H
#define SCENE_FUNCTION_H

#include <stdbool.h>
#include <stddef.h>

#include "base/vec.h"
#include "base/octet.h"

enum { FUNCTION_PARAMETERS = 56 }; /* as POV-Ray's macros */

enum step_kind {
    STEP_NUMBER, /* push number */
    STEP_LOCAL,  /* push a parameter or loop variable */
    STEP_NEGATE,
    STEP_ONE,  /* a -> one(a) */
    STEP_TWO,  /* a b -> two(a, b) */
    STEP_PLUS, /* a b -> a + b, and so on; */
    STEP_MINUS,
    STEP_TIMES,
    STEP_OVER,
    STEP_PLUS_LOCAL, /* the same where b is a parameter or loop variable, */
    STEP_MINUS_LOCAL,
    STEP_TIMES_LOCAL,
    STEP_OVER_LOCAL,
    STEP_PLUS_NUMBER, /* or a number */
    STEP_MINUS_NUMBER,
    STEP_TIMES_NUMBER,
    STEP_OVER_NUMBER,
    STEP_SELECT,  /* x negative zero positive -> one of them; without the
                   * last, `slot` is 3 and zero stands for both */
    STEP_CALL,    /* arguments -> function(arguments) */
    STEP_MANY,    /* `slot` arguments -> many(arguments) */
    STEP_FIELD,   /* x y z -> the field's value there */
    STEP_SUM,     /* first last -> sum of the next `length` steps, */
    STEP_PRODUCT, /* with the loop variable from first to last */
};

struct spots;

/* A pattern, a pigment ...: a value for each point of space. */
struct function_field {
    double (*value)(const struct function_field *field, vec3 point);
    /* The same at several, or NULL. */
    void (*values)(const struct function_field *field,
                   const struct spots *spots, double *values);
    const void *thing;
    int part; /* of several values: 0 to 4, or one of enum field_part */
};

/* A pigment, a spline, a transformation: several values for each point. */
struct function_values {
    void (*at)(const struct function_values *values, vec3 point,
               double parts[5]);
    /* The same at several, or NULL. */
    void (*all)(const struct function_values *values, const struct spots *spots,
                double (*parts)[5]);
    const void *thing;
    int count; /* of them; a spline has only x */
    bool colour;
};

struct step {
    enum step_kind kind;
    int slot;      /* of a local; the arguments of select */
    size_t length; /* of a loop's body */
    union {
        double number;
        struct {
            double (*one)(double);
            void (*ones)(octet *); /* of each, to the same bit; or NULL */
        };
        struct {
            double (*two)(double, double);
            void (*twos)(octet *, const octet *); /* into the first */
        };
        const struct function *function;
        const struct function_field *field;
        struct {
            double (*many)(const double *);
            void (*manys)(octet *, int); /* of so many points, or NULL */
        };
    };
};

struct function {
    int parameter_count;
    int slots;       /* parameters and loop variables */
    bool together;   /* values at several points are worked out at once, */
    bool even;       /* and take hardly longer than one */
    double apart;    /* steps of one evaluation that are done point by point
                      * even then, callees included */
    unsigned depth;  /* of functions that call functions */
    unsigned height; /* doubles of stack, callees included */
    double work;     /* steps of one evaluation, those of callees and of what
                      * fields are made of included, loops counting once */
    unsigned levels; /* of functions made of pigments made of functions ... */
    const struct function_values *values; /* what it gives instead of a
                                           * number, or NULL */
    const struct function_field *field;   /* that it is of its arguments, and
                                           * nothing else; or NULL */
    struct {
        struct step *items;
        size_t count, capacity;
    } steps;
};

/* What a step of kind STEP_ONE or STEP_TWO works out: these, or functions that
 * differ from them in the last bit and are there for several numbers, too. */
void step_set_one(struct step *step, double (*one)(double));
void step_set_two(struct step *step, double (*two)(double, double));

/* To be a number's power 2, 3 or 4; false: another. */
bool step_set_power(struct step *step, double exponent);

/* The stack of one evaluation; functions that need more are refused. */
enum { FUNCTION_STACK = 4096 };

/* The value for these arguments. *steps_left is counted down; when it gets
 * to 0 the result is meaningless. */
double function_evaluate(const struct function *function,
                         const double *arguments, unsigned long *steps_left);

/* Steps that one evaluation may take: functions that call two functions that
 * call two ... */
enum { FUNCTION_STEP_LIMIT = 50000000 };

/* Of a function of x, y and z; 0 where it takes more steps than a picture has
 * time for. Never NaN. */
double function_at(const struct function *function, vec3 point);

/* The same at several points. */
void function_values_at(const struct function *function,
                        const struct spots *spots, double *values);

/* Finds out whether values are worked out together, and are even, of a function
 * whose steps are there, and whether it is but a field. */
void function_join(struct function *function);

/* The one step of a function that only hands on its arguments, as those of
 * functions.inc do; else NULL. */
const struct step *function_only_step(const struct function *function);

/* The same for samples, which are taken while the scene is read: few steps. */
double function_sample(const struct function *function, vec3 point);

#endif

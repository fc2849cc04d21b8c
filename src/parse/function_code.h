/* What a user function is compiled to: steps of a stack machine on doubles. */
#ifndef PARSE_FUNCTION_CODE_H
#define PARSE_FUNCTION_CODE_H

#include "parse/operator.h"

enum { FUNCTION_PARAMETERS = 56 }; /* as POV-Ray's macros */

enum step_kind {
    STEP_NUMBER, /* push number */
    STEP_LOCAL,  /* push a parameter or loop variable */
    STEP_NEGATE,
    STEP_OPERATOR, /* a b -> a OPERATOR b */
    STEP_ONE,      /* a -> one(a) */
    STEP_TWO,      /* a b -> two(a, b) */
    STEP_SELECT,   /* x negative zero positive -> one of them; without the
                    * last, `slot` is 3 and zero stands for both */
    STEP_CALL,     /* arguments -> function(arguments) */
    STEP_SUM,      /* first last -> sum of the next `length` steps, */
    STEP_PRODUCT,  /* with the loop variable from first to last */
};

struct step {
    enum step_kind kind;
    int slot;      /* of a local; the arguments of select */
    size_t length; /* of a loop's body */
    union {
        double number;
        enum token_kind operator;
        double (*one)(double);
        double (*two)(double, double);
        const struct function *function;
    };
};

struct function {
    int parameter_count;
    int slots;       /* parameters and loop variables */
    unsigned depth;  /* of functions that call functions */
    unsigned height; /* doubles of stack, callees included */
    struct {
        struct step *items;
        size_t count, capacity;
    } steps;
};

/* The stack of one evaluation; functions that need more are refused. */
enum { FUNCTION_STACK = 4096 };

/* The value for these arguments. *steps_left is counted down; when it gets
 * to 0 the result is meaningless. */
double function_evaluate(const struct function *function,
                         const double *arguments, unsigned long *steps_left);

#endif

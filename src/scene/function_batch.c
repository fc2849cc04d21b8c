/* The stack machine of user functions, for a few points at a time: the steps
 * are found out once for all of them, and their sums and products don't wait
 * for each other. The topmost number of the stack is not on it but apart, where
 * it needs no memory. */
#include <math.h>
#include <string.h>

#include "base/clones.h"
#include "base/octet_math.h"
#include "base/quad.h"
#include "scene/function.h"
#include "scene/spots.h"

static void batch_run(const struct function *f, octet *locals, octet *top,
                      int count);

enum { ARGUMENTS_MOST = 16 }; /* of an internal function */

/* Where there are fewer points, the missing are as the first. */
static void batch_gather(const double *at, int count, octet *batch)
{
    for (int i = 0; i < OCTET; i++)
        (*batch)[i] = at[i < count ? i : 0];
}

static void batch_field(const struct function_field *field, octet point[3],
                        int count)
{
    struct spots spots;
    double values[SPOTS_MAX];
    spots.count = count;
    memcpy(spots.x, &point[0], sizeof point[0]);
    memcpy(spots.y, &point[1], sizeof point[0]);
    memcpy(spots.z, &point[2], sizeof point[0]);
    if (field->values)
        field->values(field, &spots, values);
    for (int i = 0; !field->values && i < count; i++)
        values[i] = field->value(field, spots_at(&spots, i));
    batch_gather(values, count, point);
}

static void batch_one(const struct step *step, octet *a, int count)
{
    if (step->ones)
        step->ones(a);
    else
        for (int i = 0; i < count; i++)
            (*a)[i] = step->one((*a)[i]);
}

static void batch_two(const struct step *step, octet *a, const octet *b,
                      int count)
{
    if (step->twos)
        step->twos(a, b);
    else
        for (int i = 0; i < count; i++)
            (*a)[i] = step->two((*a)[i], (*b)[i]);
}

static void batch_many(const struct step *step, octet *arguments, int count)
{
    double own[ARGUMENTS_MOST];
    if (step->manys) {
        step->manys(arguments, count);
        return;
    }
    for (int i = 0; i < count; i++) {
        for (int k = 0; k < step->slot; k++)
            own[k] = arguments[k][i];
        arguments[0][i] = step->many(own);
    }
}

/* As machine_select, for each point. */
static void batch_select(octet *arguments, int choices, int count)
{
    for (int i = 0; i < count; i++) {
        double x = arguments[0][i];
        int chosen = x < 0 ? 1 : x > 0 && choices == 4 ? 3 : 2;
        arguments[0][i] = arguments[chosen][i];
    }
}

/* One of the steps that batch_run leaves to others; `top` is the first free
 * place, and the result takes that of the first argument. Returns it. */
static octet *batch_step(const struct step *step, octet *top, int count)
{
    const struct function *callee;
    octet *first;
    switch (step->kind) {
    case STEP_ONE:
        first = top - 1;
        batch_one(step, first, count);
        return first;
    case STEP_TWO:
        first = top - 2;
        batch_two(step, first, first + 1, count);
        return first;
    case STEP_FIELD:
        first = top - 3;
        batch_field(step->field, first, count);
        return first;
    case STEP_MANY:
        first = top - step->slot;
        batch_many(step, first, count);
        return first;
    case STEP_SELECT:
        first = top - step->slot;
        batch_select(first, step->slot, count);
        return first;
    default:
        callee = step->function;
        first = top - callee->parameter_count;
        batch_run(callee, first, first + callee->slots, count);
        return first;
    }
}

/* The three kinds of steps of an operator. */
#define ARITHMETIC(name, operator)                                             \
    case STEP_##name:                                                          \
        top--;                                                                 \
        low = quad_of(top, 0) operator low;                                    \
        high = quad_of(top, QUAD) operator high;                               \
        break;                                                                 \
    case STEP_##name##_LOCAL:                                                  \
        low = low operator quad_of(&locals[step->slot], 0);                    \
        high = high operator quad_of(&locals[step->slot], QUAD);               \
        break;                                                                 \
    case STEP_##name##_NUMBER:                                                 \
        low = low operator step->number;                                       \
        high = high operator step->number;                                     \
        break;

INLINED void batch_put(octet *place, quad low, quad high)
{
    quad_into(place, 0, low);
    quad_into(place, QUAD, high);
}

/* Below what it leaves on the stack there is one number that isn't used. The
 * result takes the place of the first parameter. The topmost number is `low`
 * and `high`, whose registers every processor has that has wide ones. */
CLONES static void batch_run(const struct function *f, octet *locals,
                             octet *top, int count)
{
    const struct step *step = f->steps.items;
    const struct step *stop = step + f->steps.count;
    quad low = { 0 }, high = { 0 };
    for (; step < stop; step++) {
        switch (step->kind) {
        case STEP_NUMBER:
            batch_put(top++, low, high);
            low = high = (quad){ 0 } + step->number;
            break;
        case STEP_LOCAL:
            batch_put(top++, low, high);
            low = quad_of(&locals[step->slot], 0);
            high = quad_of(&locals[step->slot], QUAD);
            break;
        case STEP_NEGATE:
            low = -low;
            high = -high;
            break;
            ARITHMETIC(PLUS, +)
            ARITHMETIC(MINUS, -)
            ARITHMETIC(TIMES, *)
            ARITHMETIC(OVER, /)
        default:
            batch_put(top++, low, high);
            top = batch_step(step, top, count);
            low = quad_of(top, 0);
            high = quad_of(top, QUAD);
        }
    }
    batch_put(locals, low, high);
}

/* A power for one number, and for eight: to the same bit. */
#define POWER(exponent, product)                                               \
    static double power_##exponent(double x)                                   \
    {                                                                          \
        return product;                                                        \
    }                                                                          \
    CLONES static void octet_power_##exponent(octet *at)                       \
    {                                                                          \
        const octet x = *at;                                                   \
        *at = product;                                                         \
    }

POWER(2, x *x)
POWER(3, x *x *x)
POWER(4, (x * x) * (x * x))

void step_set_one(struct step *step, double (*one)(double))
{
    static const struct {
        double (*asked)(double), (*one)(double);
        void (*ones)(octet *);
    } all[] = {
        { sin, lone_sin, octet_sin },
        { cos, lone_cos, octet_cos },
        { sqrt, sqrt, octet_sqrt },
        { fabs, fabs, octet_abs },
    };
    step->one = one;
    step->ones = NULL;
    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        if (one == all[i].asked) {
            step->one = all[i].one;
            step->ones = all[i].ones;
        }
}

void step_set_two(struct step *step, double (*two)(double, double))
{
    bool arc = two == atan2;
    step->two = arc ? lone_atan2 : two;
    step->twos = arc ? octet_atan2 : NULL;
}

bool step_set_power(struct step *step, double exponent)
{
    static double (*const one[])(double) = { power_2, power_3, power_4 };
    static void (*const ones[])(octet *) = { octet_power_2, octet_power_3,
                                             octet_power_4 };
    if (exponent != 2 && exponent != 3 && exponent != 4)
        return false;
    step->kind = STEP_ONE;
    step->one = one[(int)exponent - 2];
    step->ones = ones[(int)exponent - 2];
    return true;
}

/* Places; and steps, so that those of functions in functions have an end. */
enum { BATCH_STACK = 128, BATCH_WORK = 100000 };

/* Steps that take as long as one that is done number by number, and so many of
 * these a pattern's value. */
enum { BATCH_COSTLY = 8, BATCH_PATTERN = 1000 };

static bool step_is_together(const struct step *step)
{
    switch (step->kind) {
    case STEP_SUM:
    case STEP_PRODUCT:
        return false;
    case STEP_MANY:
        return step->slot <= ARGUMENTS_MOST;
    case STEP_CALL:
        return step->function->together;
    default:
        return true;
    }
}

/* What is done point by point. */
static double step_apart(const struct step *step)
{
    switch (step->kind) {
    case STEP_ONE:
        return !step->ones;
    case STEP_TWO:
        return step->two == pow;
    case STEP_FIELD:
        return step->field->values ? 0 : BATCH_PATTERN;
    case STEP_MANY:
        return step->slot;
    case STEP_CALL:
        return step->function->apart;
    default:
        return 0;
    }
}

const struct step *function_only_step(const struct function *function)
{
    const struct step *steps = function->steps.items;
    size_t n = (size_t)function->parameter_count;
    if (function->values || function->steps.count != n + 1 ||
        (steps[n].kind != STEP_FIELD && steps[n].kind != STEP_MANY))
        return NULL;
    for (size_t i = 0; i < n; i++)
        if (steps[i].kind != STEP_LOCAL || steps[i].slot != (int)i)
            return NULL;
    return &steps[n];
}

/* Of functions that are nothing but one. */
static const struct function_field *field_alone(const struct function *function)
{
    const struct step *only = function_only_step(function);
    bool field = only && only->kind == STEP_FIELD && only->field->values;
    return field ? only->field : NULL;
}

/* Each function that is called leaves a place empty: see batch_run. */
void function_join(struct function *f)
{
    f->field = field_alone(f);
    f->together = !f->values && f->work < BATCH_WORK &&
                  (unsigned)f->slots + f->height + f->depth + 1 <= BATCH_STACK;
    f->apart = 0;
    for (size_t i = 0; i < f->steps.count; i++) {
        f->together = f->together && step_is_together(&f->steps.items[i]);
        f->apart += step_apart(&f->steps.items[i]);
    }
    f->even = f->together && f->apart * BATCH_COSTLY <= f->work;
}

/* Of up to OCTET, from number `first` on. */
static void batch_values(const struct function *function,
                         const struct spots *spots, int first, double *values)
{
    octet stack[BATCH_STACK];
    int count = spots->count - first;
    count = count < OCTET ? count : OCTET;
    batch_gather(spots->x + first, count, &stack[0]);
    batch_gather(spots->y + first, count, &stack[1]);
    batch_gather(spots->z + first, count, &stack[2]);
    batch_run(function, stack, stack + function->slots, count);
    for (int i = 0; i < count; i++)
        values[first + i] = isnan(stack[0][i]) ? 0 : stack[0][i];
}

void function_values_at(const struct function *function,
                        const struct spots *spots, double *values)
{
    int count = spots->count;
    if (function->field) {
        function->field->values(function->field, spots, values);
        for (int i = 0; i < count; i++)
            values[i] = isnan(values[i]) ? 0 : values[i];
        return;
    }
    bool together = function->even || (function->together && count > 1);
    for (int i = 0; !together && i < count; i++)
        values[i] = function_at(function, spots_at(spots, i));
    for (int i = 0; together && i < count; i += OCTET)
        batch_values(function, spots, i, values);
}

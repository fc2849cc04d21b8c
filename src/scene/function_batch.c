/* The stack machine of user functions, for a few points at a time: the steps
 * are found out once for all of them, and their sums and products don't wait
 * for each other. The topmost number of the stack is not on it but apart, where
 * it needs no memory. */
#include <math.h>
#include <string.h>

#include "base/pair_math.h"
#include "scene/function.h"
#include "scene/spots.h"

/* A number at each of the points. */
struct batch {
    pair low, high;
};

static inline struct batch batch_of(double number)
{
    return (struct batch){ pair_of(number), pair_of(number) };
}

static inline struct batch batch_negate(struct batch a)
{
    return (struct batch){ -a.low, -a.high };
}

#define BATCH_OPERATOR(name, operator)                                         \
    static inline struct batch batch_##name(struct batch a, struct batch b)    \
    {                                                                          \
        return (struct batch){ a.low operator b.low, a.high operator b.high }; \
    }

BATCH_OPERATOR(PLUS, +)
BATCH_OPERATOR(MINUS, -)
BATCH_OPERATOR(TIMES, *)
BATCH_OPERATOR(OVER, /)

static struct batch batch_run(const struct function *f,
                              const struct batch *locals, struct batch *top,
                              int count);

static inline double batch_get(const struct batch *batch, int i)
{
    return i < PAIR ? batch->low[i] : batch->high[i - PAIR];
}

static inline void batch_set(struct batch *batch, int i, double number)
{
    if (i < PAIR)
        batch->low[i] = number;
    else
        batch->high[i - PAIR] = number;
}

/* Where there are fewer points, the missing are as the first. */
static inline struct batch batch_gather(const double *at, int count)
{
    return (struct batch){
        { at[0], at[count > 1 ? 1 : 0] },
        { at[count > 2 ? 2 : 0], at[count > 3 ? 3 : 0] },
    };
}

static struct batch batch_field(const struct function_field *field,
                                const struct batch point[3], int count)
{
    struct spots spots;
    double values[SPOTS_MAX];
    spots.count = count;
    memcpy(spots.x, &point[0], sizeof spots.x);
    memcpy(spots.y, &point[1], sizeof spots.y);
    memcpy(spots.z, &point[2], sizeof spots.z);
    if (field->values)
        field->values(field, &spots, values);
    for (int i = 0; !field->values && i < count; i++)
        values[i] = field->value(field, spots_at(&spots, i));
    return batch_gather(values, count);
}

static struct batch batch_one(const struct step *step, struct batch a,
                              int count)
{
    struct batch result = a;
    if (step->ones)
        return (struct batch){ step->ones(a.low), step->ones(a.high) };
    for (int i = 0; i < count; i++)
        batch_set(&result, i, step->one(batch_get(&a, i)));
    return result;
}

static struct batch batch_two(const struct step *step, struct batch a,
                              struct batch b, int count)
{
    struct batch result = a;
    if (step->twos)
        return (struct batch){ step->twos(a.low, b.low),
                               step->twos(a.high, b.high) };
    for (int i = 0; i < count; i++)
        batch_set(&result, i, step->two(batch_get(&a, i), batch_get(&b, i)));
    return result;
}

/* As machine_select, for each point. */
static struct batch batch_select(const struct batch *arguments, int choices,
                                 int count)
{
    struct batch result = arguments[2];
    for (int i = 0; i < count; i++) {
        double x = batch_get(&arguments[0], i);
        int chosen = x < 0 ? 1 : x > 0 && choices == 4 ? 3 : 2;
        batch_set(&result, i, batch_get(&arguments[chosen], i));
    }
    return result;
}

/* One of the steps that batch_run leaves to others; `top` is the first free
 * place, and the result takes that of the first argument. Returns it. */
static struct batch *batch_step(const struct step *step, struct batch *top,
                                int count)
{
    const struct function *callee;
    struct batch *first;
    switch (step->kind) {
    case STEP_ONE:
        first = top - 1;
        *first = batch_one(step, *first, count);
        return first;
    case STEP_TWO:
        first = top - 2;
        *first = batch_two(step, first[0], first[1], count);
        return first;
    case STEP_FIELD:
        first = top - 3;
        *first = batch_field(step->field, first, count);
        return first;
    case STEP_SELECT:
        first = top - step->slot;
        *first = batch_select(first, step->slot, count);
        return first;
    default:
        callee = step->function;
        first = top - callee->parameter_count;
        *first = batch_run(callee, first, first + callee->slots, count);
        return first;
    }
}

/* The three kinds of steps of an operator. */
#define ARITHMETIC(name)                                                       \
    case STEP_##name:                                                          \
        last = batch_##name(*--top, last);                                     \
        break;                                                                 \
    case STEP_##name##_LOCAL:                                                  \
        last = batch_##name(last, locals[step->slot]);                         \
        break;                                                                 \
    case STEP_##name##_NUMBER:                                                 \
        last = batch_##name(last, batch_of(step->number));                     \
        break;

/* Below what it leaves on the stack there is one number that isn't used. */
static struct batch batch_run(const struct function *f,
                              const struct batch *locals, struct batch *top,
                              int count)
{
    const struct step *step = f->steps.items;
    const struct step *stop = step + f->steps.count;
    struct batch last = batch_of(0);
    for (; step < stop; step++) {
        switch (step->kind) {
        case STEP_NUMBER:
            *top++ = last;
            last = batch_of(step->number);
            break;
        case STEP_LOCAL:
            *top++ = last;
            last = locals[step->slot];
            break;
        case STEP_NEGATE:
            last = batch_negate(last);
            break;
            ARITHMETIC(PLUS)
            ARITHMETIC(MINUS)
            ARITHMETIC(TIMES)
            ARITHMETIC(OVER)
        default:
            *top++ = last;
            top = batch_step(step, top, count);
            last = *top;
        }
    }
    return last;
}

/* A power for one number, and for two: to the same bit. */
#define POWER(exponent, product)                                               \
    static double power_##exponent(double x)                                   \
    {                                                                          \
        return product;                                                        \
    }                                                                          \
    static pair pair_power_##exponent(pair x)                                  \
    {                                                                          \
        return product;                                                        \
    }

POWER(2, x *x)
POWER(3, x *x *x)
POWER(4, (x * x) * (x * x))

void step_set_one(struct step *step, double (*one)(double))
{
    static const struct {
        double (*asked)(double), (*one)(double);
        pair (*ones)(pair);
    } all[] = {
        { sin, lone_sin, pair_sin },
        { cos, lone_cos, pair_cos },
        { sqrt, sqrt, pair_sqrt },
        { fabs, fabs, pair_abs },
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
    step->twos = arc ? pair_atan2 : NULL;
}

bool step_set_power(struct step *step, double exponent)
{
    static double (*const one[])(double) = { power_2, power_3, power_4 };
    static pair (*const ones[])(pair) = { pair_power_2, pair_power_3,
                                          pair_power_4 };
    if (exponent != 2 && exponent != 3 && exponent != 4)
        return false;
    step->kind = STEP_ONE;
    step->one = one[(int)exponent - 2];
    step->ones = ones[(int)exponent - 2];
    return true;
}

/* Places; and steps, so that those of functions in functions have an end. */
enum { BATCH_STACK = 128, BATCH_WORK = 100000 };

/* Steps that take as long as one that is done number by number. */
enum { BATCH_COSTLY = 8 };

static bool step_is_even(const struct step *step)
{
    switch (step->kind) {
    case STEP_MANY:
    case STEP_SUM:
    case STEP_PRODUCT:
        return false;
    case STEP_FIELD:
        return step->field->values != NULL;
    case STEP_CALL:
        return step->function->even;
    default:
        return true;
    }
}

static bool step_is_costly(const struct step *step)
{
    return (step->kind == STEP_ONE && !step->ones) ||
           (step->kind == STEP_TWO && step->two == pow);
}

/* Each function that is called leaves a place empty: see batch_run. */
bool function_is_even(const struct function *f)
{
    bool even = !f->values && f->work < BATCH_WORK &&
                (unsigned)f->slots + f->height + f->depth + 1 <= BATCH_STACK;
    size_t costly = 0;
    for (size_t i = 0; even && i < f->steps.count; i++) {
        even = step_is_even(&f->steps.items[i]);
        costly += step_is_costly(&f->steps.items[i]);
    }
    return even && costly * BATCH_COSTLY <= f->steps.count;
}

void function_values_at(const struct function *function,
                        const struct spots *spots, double *values)
{
    struct batch stack[BATCH_STACK];
    int count = spots->count;
    if (!function->even) {
        for (int i = 0; i < count; i++)
            values[i] = function_at(function, spots_at(spots, i));
        return;
    }
    stack[0] = batch_gather(spots->x, count);
    stack[1] = batch_gather(spots->y, count);
    stack[2] = batch_gather(spots->z, count);
    struct batch result =
        batch_run(function, stack, stack + function->slots, count);
    for (int i = 0; i < count; i++) {
        double value = batch_get(&result, i);
        values[i] = isnan(value) ? 0 : value;
    }
}

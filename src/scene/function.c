/* The stack machine of user functions: see function.h. */
#include "scene/function.h"

static double *machine_run(const struct function *f, double *locals,
                           size_t first, size_t end, double *top,
                           unsigned long *left);

static double machine_loop(const struct function *f, const struct step *step,
                           double *locals, double *top, unsigned long *left)
{
    double last = top[1], total = step->kind == STEP_SUM ? 0 : 1;
    size_t body = (size_t)(step - f->steps.items) + 1;
    for (double i = top[0]; i <= last && *left > 0; i++) {
        locals[step->slot] = i;
        machine_run(f, locals, body, body + step->length, top, left);
        total = step->kind == STEP_SUM ? total + top[0] : total * top[0];
    }
    return total;
}

static double *machine_select(double *arguments, int count)
{
    double x = arguments[0];
    *arguments = arguments[x < 0 ? 1 : x > 0 && count == 4 ? 3 : 2];
    return arguments + 1;
}

/* One of the steps that machine_run leaves to others; `top` is the first free
 * place. Returns the new top. */
static double *machine_step(const struct function *f, const struct step *step,
                            double *locals, double *top, unsigned long *left)
{
    const struct function *callee;
    switch (step->kind) {
    case STEP_ONE:
        top[-1] = step->one(top[-1]);
        return top;
    case STEP_TWO:
        top[-2] = step->two(top[-2], top[-1]);
        return top - 1;
    case STEP_MANY:
        top -= step->slot;
        *top = step->many(top);
        return top + 1;
    case STEP_FIELD:
        top[-3] = step->field->value(step->field,
                                     vec3_make(top[-3], top[-2], top[-1]));
        return top - 2;
    case STEP_SELECT:
        return machine_select(top - step->slot, step->slot);
    case STEP_CALL:
        callee = step->function;
        top -= callee->parameter_count;
        machine_run(callee, top, 0, callee->steps.count, top + callee->slots,
                    left);
        *top = top[callee->slots];
        return top + 1;
    default:
        top -= 2;
        *top = machine_loop(f, step, locals, top, left);
        return top + 1;
    }
}

/* The three kinds of steps of an operator. */
#define ARITHMETIC(name, operator)                                             \
    case STEP_##name:                                                          \
        top--;                                                                 \
        top[-1] = top[-1] operator top[0];                                     \
        break;                                                                 \
    case STEP_##name##_LOCAL:                                                  \
        top[-1] = top[-1] operator locals[step->slot];                         \
        break;                                                                 \
    case STEP_##name##_NUMBER:                                                 \
        top[-1] = top[-1] operator step->number;                               \
        break;

static double *machine_run(const struct function *f, double *locals,
                           size_t first, size_t end, double *top,
                           unsigned long *left)
{
    const struct step *step = f->steps.items + first;
    const struct step *stop = f->steps.items + end;
    unsigned long rest = *left;
    for (; step < stop && rest > 0; step++) {
        rest--;
        switch (step->kind) {
        case STEP_NUMBER:
            *top++ = step->number;
            break;
        case STEP_LOCAL:
            *top++ = locals[step->slot];
            break;
        case STEP_NEGATE:
            top[-1] = -top[-1];
            break;
            ARITHMETIC(PLUS, +)
            ARITHMETIC(MINUS, -)
            ARITHMETIC(TIMES, *)
            ARITHMETIC(OVER, /)
        default:
            *left = rest;
            top = machine_step(f, step, locals, top, left);
            rest = *left;
            step += step->length;
        }
    }
    *left = rest;
    return top;
}

double function_evaluate(const struct function *function,
                         const double *arguments, unsigned long *steps_left)
{
    double stack[FUNCTION_STACK];
    for (int i = 0; i < function->parameter_count; i++)
        stack[i] = arguments[i];
    machine_run(function, stack, 0, function->steps.count,
                stack + function->slots, steps_left);
    return stack[function->slots];
}

static double function_within(const struct function *function, vec3 point,
                              unsigned long left)
{
    double stack[FUNCTION_STACK];
    stack[0] = point.x;
    stack[1] = point.y;
    stack[2] = point.z;
    machine_run(function, stack, 0, function->steps.count,
                stack + function->slots, &left);
    double value = stack[function->slots];
    return left == 0 || isnan(value) ? 0 : value;
}

double function_at(const struct function *function, vec3 point)
{
    enum { STEPS = 1000000 };
    return function_within(function, point, STEPS);
}

double function_sample(const struct function *function, vec3 point)
{
    enum { STEPS = 1000 };
    return function_within(function, point, STEPS);
}

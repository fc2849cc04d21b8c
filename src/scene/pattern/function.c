/* function: what a function of x, y and z gives. */
#include "scene/function.h"

#include "scene/pattern.h"
#include "scene/spots.h"

/* What is above 1 counts by its fraction, before frequency and phase; what is
 * below 0 by itself (measured). */
static inline double function_cut(double value)
{
    return value > 1 ? value - floor(value) : value;
}

static double function_value(const struct pattern *pattern, vec3 point)
{
    const struct made_pattern *made = pattern->parameters;
    return made->function ? function_cut(function_at(made->function, point))
                          : 0;
}

static void function_values(const struct pattern *pattern,
                            const struct spots *spots, double *values)
{
    const struct made_pattern *made = pattern->parameters;
    if (made->function)
        function_values_at(made->function, spots, values);
    for (int i = 0; i < spots->count; i++)
        values[i] = made->function ? function_cut(values[i]) : 0;
}

const struct pattern_kind function_pattern = {
    .name = "function",
    .help = "the value of a function of x, y and z: function { x * y }",
    .size = sizeof(struct made_pattern),
    .arguments = made_pattern_fields,
    .value = function_value,
    .values = function_values,
};

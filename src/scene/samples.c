/* Samples of functions: see samples.h. */
#include "scene/samples.h"

#include "base/random.h"

/* From a quarter of a unit to 32 units around the origin. */
struct terms samples_take(struct arena *arena,
                          double (*value)(const void *thing, vec3 point),
                          const void *thing)
{
    enum { SAMPLES = 64 };
    double *values = ARENA_ARRAY(arena, double, SAMPLES);
    for (uint64_t i = 0; i < SAMPLES; i++) {
        double reach = ldexp(1, (int)(i % 8) - 2);
        vec3 unit = { random_unit(3 * i), random_unit(3 * i + 1),
                      random_unit(3 * i + 2) };
        vec3 point = vec3_sub(vec3_scale(unit, 2), vec3_make(1, 1, 1));
        values[i] = value(thing, vec3_scale(point, reach));
    }
    return (struct terms){ values, SAMPLES };
}

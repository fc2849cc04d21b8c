/* brick: courses of bricks (block 1) in mortar (block 0). */
#include "base/clones.h"
#include "scene/pattern.h"
#include "scene/spots.h"

struct brick {
    vec3 size; /* of a brick and its share of mortar */
    double mortar;
};

static const struct brick brick_defaults = { { 8, 3, 4.5 }, 0.5 };

static const double brick_colours[][3] = { { 0.5, 0.5, 0.5 },
                                           { 0.6, 0.15, 0.15 } };

static const struct field brick_items[] = {
    { "brick_size", FIELD_VECTOR, offsetof(struct brick, size), 0, 0,
      "brick with mortar, default <8, 3, 4.5>", false },
    { "mortar", FIELD_FLOAT, offsetof(struct brick, mortar), 0, 0,
      "thickness of the mortar, default 0.5", false },
    { .name = NULL },
};

/* Whether a coordinate in brick lengths is in the mortar, which comes first.
 * A brick of size 0 makes NaN here and is all mortar, as in POV-Ray. */
static bool brick_in_mortar(double coordinate, double mortar)
{
    return !(coordinate - floor(coordinate) > mortar);
}

/* Measured: mortar is below, left and in front of brick and mortar counted
 * from 0; even courses are shifted by half a brick in z, odd ones in x. */
CLONES static void brick_values(const struct pattern *pattern,
                                const struct spots *restrict spots,
                                double *restrict values)
{
    const struct brick *brick = pattern->parameters;
    const vec3 size = brick->size;
    const double offset = brick->mortar + 1e-10;
    const vec3 mortar = vec3_make(
        brick->mortar / size.x, brick->mortar / size.y, brick->mortar / size.z);
    for (int i = 0; i < spots->count; i++) {
        double x = (spots->x[i] + offset) / size.x;
        double y = (spots->y[i] + offset) / size.y;
        double z = (spots->z[i] + offset) / size.z;
        bool odd = pattern_odd(floor(y));
        x += odd ? 0.5 : 0;
        z += odd ? 0 : 0.5;
        int mortars = brick_in_mortar(x, mortar.x) +
                      brick_in_mortar(y, mortar.y) +
                      brick_in_mortar(z, mortar.z);
        values[i] = mortars > 0 ? 0 : 1;
    }
}

const struct pattern_kind brick_pattern = {
    .name = "brick",
    .help = "a brick wall: colour of the mortar, colour of the bricks",
    .size = sizeof(struct brick),
    .defaults = &brick_defaults,
    .items = brick_items,
    .blocks = 2,
    .block_colours = brick_colours,
    .values = brick_values,
};

/* What a shape that may reach far is contained by: a box or a ball. Nothing of
 * it is beyond. */
#ifndef SCENE_CONTAINER_H
#define SCENE_CONTAINER_H

#include "base/field.h"
#include "scene/cell.h"
#include "scene/ray.h"

struct container {
    bool ball;      /* not a box */
    vec3 low, high; /* corners of the box, as written */
    vec3 centre;    /* of the ball */
    double radius;
    struct box3 box; /* around it: container_prepare */
};

/* What tells it from others: rows of its shape's table, `struct container
 * container` being a member of `type`. */
#define CONTAINER_FIELDS(type)                                                 \
    { "low", FIELD_VECTOR, offsetof(type, container.low), 0, 0, "a corner" },  \
        { "high",                                                              \
          FIELD_VECTOR,                                                        \
          offsetof(type, container.high),                                      \
          0,                                                                   \
          0,                                                                   \
          "the corner opposite to it" },                                       \
        { "centre", FIELD_VECTOR, offsetof(type, container.centre), 0,         \
          0,        "of the ball" },                                           \
    {                                                                          \
        "radius", FIELD_FLOAT, offsetof(type, container.radius), 0, 0,         \
            "of the ball"                                                      \
    }

/* POV-Ray's: the box from <-1, -1, -1> to <1, 1, 1>. */
struct container container_default(void);

/* Once it has been read. Returns NULL or what is wrong with it. */
const char *container_prepare(struct container *container);

/* Where a ray enters and leaves it: two hits whose parts are `part` and
 * whatever more tells the side. False: nowhere. */
bool container_interval(const struct container *container,
                        const struct ray *ray, int part, struct hit ends[2]);

/* The outward normal there; `side` is the hit's part less `part`. */
vec3 container_normal(const struct container *container, vec3 point, int side);

bool container_holds(const struct container *container, vec3 point);

/* Whether the cell may meet it, and whether all of the cell is in it. */
bool container_meets(const struct container *container,
                     const struct cell *cell);
bool container_covers(const struct container *container,
                      const struct cell *cell);

#endif

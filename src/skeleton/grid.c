/* The grid around a scene: see grid.h. */
#include "skeleton/grid.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/memory.h"
#include "scene/mesh.h"
#include "skeleton/complex.h"

enum {
    MARGIN = 3,         /* voxels besides those of the box, in all: walls at its
                         * sides run through the middle of voxels */
    LIGHTS = 64,        /* that are asked what they see */
    THINGS_BEFORE = 64, /* a wall, when it is looked for */
    VOXEL_BYTES = 24    /* of all maps of a skeleton together */
};

/* How many times longer the grid may get to hold the camera, a lamp, or a
 * wall. What is farther away is outside. */
static const double camera_stretch = 4, other_stretch = 2;

/* Things that reach so many times farther from the camera than the nearer half
 * and all others together are skies, grounds, or far away: the grid cuts them,
 * or leaves them outside. */
static const double vast = 16;
/* The same where the picture needs no more than the chambers that it shows:
 * something small and far off would leave a cave two voxels [cave: .062 ->
 * .003]. */
static const double vast_still = 4;

/* Without anything bounded walls are looked for up to here. */
static const double far_away = 1e5;

static double longest_side(struct box3 box)
{
    vec3 size = vec3_sub(box.high, box.low);
    return fmax(size.x, fmax(size.y, size.z));
}

/* Adds the point unless the box would get longer than `limit`. */
static void stretch(struct box3 *box, vec3 point, double limit)
{
    struct box3 larger = box3_add(*box, point);
    if (vec3_finite(point) && longest_side(larger) <= limit)
        *box = larger;
}

static const vec3 ways[6] = { { -1, 0, 0 }, { 1, 0, 0 },  { 0, -1, 0 },
                              { 0, 1, 0 },  { 0, 0, -1 }, { 0, 0, 1 } };

/* Adds what a viewer sees along the axes: walls that have no bounds. */
static void look_around(struct box3 *box, const struct world *world, vec3 from,
                        double limit)
{
    for (int i = 0; i < 6; i++) {
        struct intersection at;
        struct ray ray = { from, ways[i] };
        if (world_closest(world, &ray, 1e-6, RAY_SIGHT, &at) && at.t < far_away)
            stretch(box, at.point, limit);
    }
}

/* Whether what is met has no bounds, as a plane. */
static bool is_endless(const struct intersection *at)
{
    const struct solid *solid = at->leaf->solid;
    while (solid && solid->parent)
        solid = solid->parent;
    return solid && !solid_is_bounded(solid);
}

/* The first such thing that a ray meets, at so far at most, whatever stands
 * before it. */
static bool find_endless(const struct world *world, const struct ray *ray,
                         double far, struct intersection *at)
{
    double from = 1e-6;
    for (int i = 0; i < THINGS_BEFORE; i++) {
        if (!world_closest(world, ray, from, RAY_SIGHT, at) || at->t > far)
            return false;
        if (is_endless(at))
            return true;
        from = at->t * (1 + 1e-9);
    }
    return false;
}

/* Adds the room whose walls have no bounds, but shut in who stands there, as
 * six planes do: all of it, however small the things in it are. Whether there
 * is one. */
static bool add_room(struct box3 *box, const struct world *world, vec3 from,
                     double far)
{
    struct box3 room = *box;
    for (int i = 0; i < 6; i++) {
        const struct ray ray = { from, ways[i] };
        struct intersection at;
        if (!find_endless(world, &ray, far, &at))
            return false;
        room = box3_add(room, at.point);
    }
    *box = room;
    return true;
}

/* Adds the room that shuts in who stands there, of whatever its walls are: they
 * are no sky and not far away, however small and near all other things are.
 * Looks askew as well, past what stands before a wall. */
static void add_walls(struct box3 *box, const struct world *world, vec3 from,
                      double far)
{
    struct box3 room = *box;
    for (int i = 0; i < 27; i++) {
        const vec3 way = { i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1 };
        struct intersection at;
        if (i == 13) /* no way at all */
            continue;
        const struct ray ray = { from, vec3_normalise(way) };
        if (!world_closest(world, &ray, 1e-6, RAY_SIGHT, &at) ||
            at.t > far * vec3_length(way))
            return;
        room = box3_add(room, at.point);
    }
    *box = room;
}

struct thing {
    struct box3 box;
    double reach; /* from the camera */
    size_t number;
};

struct things {
    struct arena *arena;
    vec3 eye;
    struct thing *items;
    size_t count, capacity;
};

static void add_thing(struct things *things, struct box3 box)
{
    if (box3_is_finite(box) && !box3_is_empty(box))
        *ARRAY_PUSH(things->arena, things) =
            (struct thing){ box, longest_side(box3_add(box, things->eye)),
                            things->count };
}

static void add_solid(void *context, const struct solid *solid)
{
    add_thing(context, solid->surface);
}

static void add_mesh(void *context, const struct leaf *leaf)
{
    add_thing(context,
              affine_box(leaf->pose->outward, leaf->object->mesh->bounds));
}

static int thing_order(const void *first, const void *second)
{
    const struct thing *a = first, *b = second;
    if (a->reach != b->reach)
        return a->reach < b->reach ? -1 : 1;
    return a->number < b->number ? -1 : a->number > b->number;
}

/* Around all things but those so many times farther. */
static struct box3 box_of_things(const struct world *world, vec3 eye,
                                 double far)
{
    struct things things = { .arena = arena_new(0), .eye = eye };
    struct box3 box = box3_empty(), seen = box3_add(box, eye);
    world_visit(world, add_solid, add_mesh, &things);
    if (things.count > 0)
        qsort(things.items, things.count, sizeof *things.items, thing_order);
    for (size_t i = 0; i < things.count; i++) {
        double size = longest_side(seen);
        if (size > 0 && 2 * i >= things.count &&
            things.items[i].reach > far * size)
            break;
        box = box3_union(box, things.items[i].box);
        seen = box3_union(seen, things.items[i].box);
    }
    arena_free(things.arena);
    return box;
}

/* Adds the room around the camera, or else that around a lamp. */
static void add_rooms(struct box3 *box, const struct world *world,
                      const struct camera *camera)
{
    size_t count;
    const struct light *lights = world_lights(world, &count);
    double size = longest_side(*box);
    double far = size > 0 ? vast * size : far_away;
    bool found = add_room(box, world, camera->location, far);
    for (size_t i = 0; i < count && i < LIGHTS && !found; i++)
        found = !lights[i].parallel &&
                add_room(box, world, lights[i].location, far);
}

/* With the camera in it, unless it is to be `still`: then a camera outside
 * counts for nothing. */
static struct box3 find_box(const struct world *world,
                            const struct camera *camera, bool still)
{
    struct box3 box =
        box_of_things(world, camera->location, still ? vast_still : vast);
    size_t count;
    const struct light *lights = world_lights(world, &count);
    if (box3_is_empty(box))
        box = box3_add(box, camera->location);
    add_rooms(&box, world, camera);
    double size = longest_side(box);
    if (!still)
        stretch(&box, camera->location, camera_stretch * size);
    else if (size > 0)
        add_walls(&box, world, camera->location, vast * size);
    size = longest_side(box);
    double limit = size > 0 ? other_stretch * size : far_away;
    if (!still || box3_contains(box, camera->location))
        look_around(&box, world, camera->location, limit);
    for (size_t i = 0; i < count; i++) {
        if (lights[i].parallel)
            continue;
        stretch(&box, lights[i].location, limit);
        if (i < LIGHTS && box3_contains(box, lights[i].location))
            look_around(&box, world, lights[i].location, limit);
    }
    return box;
}

static double voxels_needed(const double *size)
{
    return size[0] * size[1] * size[2];
}

static void grid_sizes(struct box3 box, int resolution, double *edge,
                       double *size)
{
    double longest = longest_side(box);
    vec3 extent = vec3_sub(box.high, box.low);
    *edge = longest > 0 ? longest / (resolution - MARGIN) : 1.0 / resolution;
    for (int i = 0; i < 3; i++)
        size[i] = ceil(vec3_component(extent, i) / *edge - 1e-9) + MARGIN;
}

static bool fits(struct box3 box, int resolution, double bytes)
{
    double edge, size[3];
    grid_sizes(box, resolution, &edge, size);
    return voxels_needed(size) * VOXEL_BYTES <= bytes && resolution < 65535;
}

static void report_size(struct box3 box, int resolution, double bytes,
                        struct diag *diag)
{
    double edge, size[3];
    int possible = resolution;
    while (possible > VOXELS_RESOLUTION_LEAST && !fits(box, possible, bytes))
        possible = possible / 2;
    grid_sizes(box, resolution, &edge, size);
    diag_print(diag, DIAG_ERROR, span_none(), NULL,
               "a skeleton of resolution %d has %.0f x %.0f x %.0f voxels and "
               "needs %.1f GB of memory; it may use %.1f GB, enough for "
               "resolution %d",
               resolution, size[0], size[1], size[2],
               voxels_needed(size) * VOXEL_BYTES / 1e9, bytes / 1e9, possible);
}

/* Half of the memory, or as many voxels as a complex can number. */
static double bytes_allowed(void)
{
    return fmin((double)memory_available() / 2,
                (double)COMPLEX_VOXELS_MAX * VOXEL_BYTES);
}

bool grid_place(struct voxels *grid, const struct world *world,
                const struct camera *camera, struct grid_wish wish,
                struct diag *diag)
{
    struct box3 box = find_box(world, camera, wish.still);
    int resolution = wish.resolution;
    double bytes = bytes_allowed(), size[3];
    if (resolution <= 0)
        resolution = VOXELS_RESOLUTION;
    if (resolution < VOXELS_RESOLUTION_LEAST)
        resolution = VOXELS_RESOLUTION_LEAST;
    if (!fits(box, resolution, bytes)) {
        report_size(box, resolution, bytes, diag);
        return false;
    }
    grid_sizes(box, resolution, &grid->edge, size);
    vec3 half = vec3_scale(vec3_make(size[0], size[1], size[2]), 0.5);
    vec3 middle = vec3_mix(box.low, box.high, 0.5);
    grid->origin = vec3_along(middle, half, -grid->edge);
    for (int i = 0; i < 3; i++)
        grid->size[i] = (int)size[i];
    grid->empty = NULL;
    return true;
}

/* Cones and beams around targets: see photon_aim.h. */
#include "tracer/photon_aim.h"

#include "base/memory.h"
#include "base/random.h"
#include "base/warp.h"
#include "scene/photon.h"
#include "shade/area.h"

enum { COLOURS_MOST = 16 }; /* that have photons of their own */

/* A target, and what it says. */
struct target {
    struct box3 box;
    const struct photon_flags *flags;
    int colours; /* that it divides light into; 0: it doesn't */
};

struct targets {
    struct target *items; /* by number; 0 is none */
};

static void target_add(struct targets *targets, const struct leaf *leaf,
                       struct box3 box)
{
    struct target *target = &targets->items[leaf->look->target];
    if (leaf->look->target == 0)
        return;
    target->box = target->flags ? box3_union(target->box, box) : box;
    target->flags = leaf->look->photons;
    const struct interior *interior = leaf->look->interior;
    if (interior && interior->dispersion != 1 &&
        interior->dispersion_samples > target->colours)
        target->colours = interior->dispersion_samples;
}

static void target_add_solid(struct targets *targets, const struct solid *solid,
                             struct box3 box)
{
    if (solid->leaf)
        target_add(targets, solid->leaf, box);
    for (size_t i = 0; i < solid->child_count; i++)
        target_add_solid(targets, solid->children[i], box);
}

static void visit_solid(void *context, const struct solid *solid)
{
    target_add_solid(context, solid, solid->surface);
}

static void visit_mesh(void *context, const struct leaf *leaf)
{
    if (leaf->look->target)
        target_add(context, leaf,
                   affine_box(leaf->pose->outward, leaf->object->mesh->bounds));
}

static vec3 box_corner(struct box3 box, int number)
{
    return vec3_make(number & 1 ? box.high.x : box.low.x,
                     number & 2 ? box.high.y : box.low.y,
                     number & 4 ? box.high.z : box.low.z);
}

/* How far from its location an area light begins. */
static double lamp_reach(const struct lamp *lamp)
{
    const struct light *light = lamp->light;
    if (!light->area || !light->photons.area)
        return 0;
    return (vec3_length(light->axis1) + vec3_length(light->axis2)) / 2;
}

/* All directions from the lamp to the box, about. */
static void aim_cone(struct photon_aim *aim, struct box3 box, double size)
{
    const struct lamp *lamp = aim->lamp;
    vec3 from = lamp->light->location;
    double cosine = 1, distance = vec3_length(vec3_sub(aim->centre, from));
    aim->axis = vec3_normalise(vec3_sub(aim->centre, from));
    for (int i = 0; i < 8; i++) {
        vec3 corner = box_corner(box, i);
        vec3 way = vec3_sub(corner, from);
        /* A wide lamp sees it wider. */
        double wider = atan2(lamp_reach(lamp), vec3_length(way));
        double angle =
            acos(fmin(fmax(vec3_dot(vec3_normalise(way), aim->axis), -1), 1));
        cosine = fmin(cosine, cos(fmin(angle + wider, WARP_PI)));
    }
    aim->rise = 1 - cosine;
    if (!(cosine > 0.05) || !(distance > 0) || box3_contains(box, from)) {
        aim->rise = 2;
        aim->axis = vec3_make(0, 1, 0);
    }
    if (lamp->light->kind == LIGHT_SPOT && lamp_reach(lamp) == 0 &&
        1 - lamp->cosine_falloff < aim->rise) {
        aim->axis = lamp->axis;
        aim->rise = 1 - lamp->cosine_falloff;
    }
    aim->extent = 2 * WARP_PI * aim->rise;
    distance = fmax(distance, size / 4);
    aim->across = aim->extent * distance * distance;
}

static void aim_beam(struct photon_aim *aim, double size)
{
    const struct lamp *lamp = aim->lamp;
    vec3 away = vec3_sub(aim->centre, lamp->light->location);
    aim->beam = true;
    aim->axis = lamp->axis;
    aim->radius = size;
    if (lamp->light->kind == LIGHT_CYLINDER && lamp->light->falloff < size) {
        aim->radius = lamp->light->falloff;
        aim->centre = vec3_along(lamp->light->location, lamp->axis,
                                 vec3_dot(away, lamp->axis));
    }
    aim->extent = aim->across = WARP_PI * aim->radius * aim->radius;
}

/* False if nothing is sent. */
static bool aim_new(struct photon_aim *aim, const struct lamp *lamp,
                    const struct target *target, struct box3 everything)
{
    const struct photon_flags *photons = &lamp->light->photons;
    const struct photon_flags *flags = target->flags;
    if (!flags || lamp->light->shadowless ||
        !(photon_happens(photons->refraction, flags->refraction) ||
          photon_happens(photons->reflection, flags->reflection)))
        return false;
    struct box3 box = target->box;
    if (!box3_is_finite(box))
        box = box3_intersection(box, everything);
    if (box3_is_empty(box) || !box3_is_finite(box))
        box = everything;
    double size = vec3_length(vec3_sub(box.high, box.low)) / 2;
    *aim = (struct photon_aim){ .lamp = lamp,
                                .centre = vec3_mix(box.low, box.high, 0.5),
                                .colours = target->colours };
    if (lamp_is_parallel(lamp))
        aim_beam(aim, size);
    else
        aim_cone(aim, box, size);
    aim->across /= flags->spacing * flags->spacing;
    return aim->across > 0 && isfinite(aim->across);
}

static void aims_push(struct photon_aims *aims, const struct photon_aim *aim)
{
    size_t n = aims->count;
    if ((n & (n - 1)) == 0) /* a power of 2: all the room is taken */
        aims->items =
            memory_resize(aims->items, (n ? 2 * n : 1) * sizeof *aims->items);
    aims->items[aims->count++] = *aim;
}

static void aims_add(struct photon_aims *aims, const struct lamps *lamps,
                     const struct targets *targets, unsigned count)
{
    struct box3 everything = world_bounds(lamps->world);
    if (box3_is_empty(everything))
        everything = (struct box3){ { -1, -1, -1 }, { 1, 1, 1 } };
    for (size_t i = 0; i < lamps->count; i++)
        for (unsigned k = 1; k <= count; k++) {
            struct photon_aim aim;
            if (!aim_new(&aim, &lamps->items[i], &targets->items[k],
                         everything))
                continue;
            aims->many = aims->count == PHOTON_AIMS_MOST;
            if (aims->many)
                return;
            aim.target = k;
            aims_push(aims, &aim);
        }
}

struct photon_aims photon_aims_new(const struct lamps *lamps)
{
    const struct photon_settings *said = &lamps->scene->settings.photons;
    unsigned count = world_targets(lamps->world);
    struct photon_aims aims = { .spacing = said->spacing };
    struct targets targets = { memory_new((count + 1) *
                                          sizeof(struct target)) };
    world_visit(lamps->world, visit_solid, visit_mesh, &targets);
    aims_add(&aims, lamps, &targets, count);
    memory_free(targets.items);
    double across = 0;
    for (size_t i = 0; i < aims.count; i++)
        across += aims.items[i].across;
    if (!(aims.spacing > 0))
        aims.spacing = sqrt(across / said->count);
    for (size_t i = 0; i < aims.count; i++) {
        struct photon_aim *aim = &aims.items[i];
        double colours = fmin(fmax(aim->colours, 1), COLOURS_MOST);
        double side = ceil(sqrt(aim->across * colours) / aims.spacing);
        aims.photons += side * side;
        aim->side = side >= 1 && side < 1e6 ? (size_t)side : 1;
    }
    return aims;
}

/* Photons are shot from the points of an area light's grid, as in POV-Ray. */
static vec3 grid_point(const struct lamps *lamps, const struct lamp *lamp,
                       vec3 point, const double u[2])
{
    const struct light *light = lamp->light;
    if (!lamps_soft(lamps, lamp))
        return light->location;
    struct area_grid grid = area_grid_new(lamp, point, 0);
    return area_grid_point(&grid, (int)(u[0] * light->size1),
                           (int)(u[1] * light->size2));
}

static bool start_beam(const struct photon_aim *aim, const double u[2],
                       struct photon_start *start)
{
    double x, y;
    vec3 a, b;
    warp_disc(u, &x, &y);
    warp_frame(aim->axis, &a, &b);
    vec3 at = vec3_along(vec3_along(aim->centre, a, x * aim->radius), b,
                         y * aim->radius);
    double along =
        vec3_dot(vec3_sub(at, aim->lamp->light->location), aim->axis);
    start->ray = (struct ray){ vec3_along(at, aim->axis, -along), aim->axis };
    return along > 0;
}

bool photon_aim_start(const struct photon_aim *aim, const struct lamps *lamps,
                      size_t row, size_t place, uint64_t key,
                      struct photon_start *start)
{
    double jitter = lamps->scene->settings.photons.jitter, u[2], v[2];
    double side = (double)aim->side;
    u[0] = ((double)place + 0.5 +
            jitter * (random_unit(random_key(key, 0)) - 0.5)) /
           side;
    u[1] =
        ((double)row + 0.5 + jitter * (random_unit(random_key(key, 1)) - 0.5)) /
        side;
    v[0] = random_unit(random_key(key, 2));
    v[1] = random_unit(random_key(key, 3));
    start->extent = aim->extent / (side * side);
    if (aim->beam)
        return start_beam(aim, u, start);
    const struct light *light = aim->lamp->light;
    start->ray.direction = warp_cone(u, aim->axis, aim->rise);
    start->ray.origin = light->photons.area
                            ? grid_point(lamps, aim->lamp, aim->centre, v)
                            : light->location;
    return true;
}

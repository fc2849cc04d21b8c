/* disc { CENTRE, NORMAL, RADIUS [, HOLE_RADIUS] }. In CSG it acts as the half
 * space behind it, as POV-Ray's does. */
#include "base/warp.h"
#include "scene/primitive.h"

struct disc {
    vec3 centre, normal; /* unit */
    double radius, hole;
};

static const struct field disc_arguments[] = {
    { "centre", FIELD_VECTOR, offsetof(struct disc, centre), 0, 0, "the middle",
      false },
    { "normal", FIELD_VECTOR, offsetof(struct disc, normal), 0, 0,
      "the direction it faces; any length", false },
    { "radius", FIELD_FLOAT, offsetof(struct disc, radius), 0, 0, "the radius",
      false },
    { "hole radius", FIELD_FLOAT, offsetof(struct disc, hole), 0, 0,
      "the radius of the hole in the middle, 0", true },
    { .name = NULL },
};

static const char *disc_prepare(void *shape, struct arena *arena,
                                const char **warning)
{
    struct disc *disc = shape;
    double length = vec3_length(disc->normal);
    (void)arena;
    if (length > 0 && isfinite(length))
        disc->normal = vec3_scale(disc->normal, 1 / length);
    else
        *warning = "its normal has no direction";
    return NULL;
}

/* Along each axis the rim reaches r sqrt(1 - n^2) from the centre. */
static struct box3 disc_bounds(const void *shape)
{
    const struct disc *disc = shape;
    double r = fabs(disc->radius);
    vec3 n = disc->normal;
    vec3 half = { r * sqrt(fmax(0, 1 - n.x * n.x)),
                  r * sqrt(fmax(0, 1 - n.y * n.y)),
                  r * sqrt(fmax(0, 1 - n.z * n.z)) };
    return (struct box3){ vec3_sub(disc->centre, half),
                          vec3_add(disc->centre, half) };
}

static void disc_intersect(const void *shape, const struct ray *ray,
                           struct hits *hits)
{
    const struct disc *disc = shape;
    double slope = vec3_dot(disc->normal, ray->direction);
    if (slope == 0)
        return;
    vec3 o = vec3_sub(ray->origin, disc->centre);
    double t = -vec3_dot(disc->normal, o) / slope;
    vec3 p = vec3_along(o, ray->direction, t);
    double r2 = vec3_dot(p, p);
    if (r2 <= disc->radius * disc->radius && r2 >= disc->hole * disc->hole)
        hits_add(hits, t, 0);
}

static vec3 disc_normal(const void *shape, const vec3 *at,
                        const struct hit *hit)
{
    const struct disc *disc = shape;
    (void)at;
    (void)hit;
    return disc->normal;
}

static bool disc_inside(const void *shape, vec3 point)
{
    const struct disc *disc = shape;
    return vec3_dot(disc->normal, vec3_sub(point, disc->centre)) < 0;
}

static unsigned disc_meets(const void *shape, const struct cell *cell)
{
    const struct disc *disc = shape;
    vec3 d = vec3_sub(cell->centre, disc->centre);
    if (fabs(vec3_dot(disc->normal, d)) > cell_reach(cell, disc->normal))
        return 0;
    bool apart = cell_nearest(cell, disc->centre) > fabs(disc->radius) ||
                 cell_farthest(cell, disc->centre) < fabs(disc->hole);
    return apart ? CELL_BORDER : CELL_SURFACE | CELL_BORDER;
}

static int disc_patches(const void *shape, struct patch *patches)
{
    const struct disc *disc = shape;
    vec3 a, b;
    warp_frame(disc->normal, &a, &b);
    patches[0] = (struct patch){ .kind = PATCH_DISC,
                                 .at = disc->centre,
                                 .a = vec3_scale(a, disc->radius),
                                 .b = vec3_scale(b, disc->radius) };
    return 1;
}

const struct primitive disc_primitive = {
    .name = "disc",
    .help = "a flat disc, with a hole if a second radius is given",
    .size = sizeof(struct disc),
    .arguments = disc_arguments,
    .solid = true,
    .beyond = true,
    .bounded = BOUNDS_IGNORED,
    .prepare = disc_prepare,
    .bounds = disc_bounds,
    .intersect = disc_intersect,
    .normal = disc_normal,
    .inside = disc_inside,
    .meets = disc_meets,
    .patches = disc_patches,
};

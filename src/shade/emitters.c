/* Picking points on what glows: see emitters.h. A part's share is in
 * proportion to area and glow, so that the density per area at a point is its
 * glow over the sum of all, whatever part it is on. */
#include "shade/emitters.h"

#include "base/array.h"
#include "base/draw.h"
#include "base/warp.h"
#include "scene/material.h"
#include "scene/mesh.h"
#include "scene/primitive.h"
#include "shade/emitter_points.h"

enum {
    PARTS_MAX = 4 * 1000 * 1000, /* of the scene; more are left to chance */
    STREWN_MOST = 64, /* shapes without patches: in a crowd they hide each other
                       * from most of the places they are picked for */
    LINES = 2048,     /* to find points of each, */
    LINES_DENSE = 16, /* times as many of a few, if these find fewer */
    POINTS_FEW = 256  /* than so many */
};

/* A patch of a shape, or one of its points, or a triangle of a mesh. */
struct part {
    const struct leaf *leaf;
    uint32_t number;
};

struct emitters {
    struct arena *arena;
    struct part_list {
        struct part *items;
        size_t count, capacity;
    } parts;
    struct sum_list {
        double *items;
        size_t count, capacity;
    } sums; /* of area times glow, up to and with each part */
    double total;
    struct share_list {
        struct emitter_share *items;
        size_t count, capacity;
    } shares; /* of leaves, of `total` 1 when all are known */
    struct emitter_points points; /* of shapes without patches */
    size_t strewn;                /* how many of these glow */
    bool *picked;                 /* by leaf number: emitters_pick finds it */
};

/* About how bright a texture glows; 0 if it doesn't. */
static double texture_glow(const struct texture *texture)
{
    double glow = 0;
    for (size_t i = 0; i < texture->count; i++) {
        const struct layer *layer = &texture->layers[i];
        double tone = 1;
        if (layer->pigment->kind == PIGMENT_COLOUR)
            tone = rgb_peak(colour_rgb(layer->pigment->colour));
        glow += rgb_peak(layer->finish->emission) * tone;
    }
    return isfinite(glow) ? glow : 0;
}

static const struct texture *triangle_texture(const struct leaf *leaf,
                                              uint32_t number)
{
    const struct mesh *mesh = leaf->object->mesh;
    uint32_t own = mesh->triangles[number].texture;
    bool has = own < mesh->texture_count && mesh->textures[own];
    return has ? mesh->textures[own] : leaf->look->texture;
}

static struct patch triangle_patch(const struct leaf *leaf, uint32_t number)
{
    const struct mesh *mesh = leaf->object->mesh;
    const uint32_t *v = mesh->triangles[number].vertex;
    vec3 at = mesh->vertices[v[0]];
    struct patch patch = { .kind = PATCH_TRIANGLE,
                           .at = at,
                           .a = vec3_sub(mesh->vertices[v[1]], at),
                           .b = vec3_sub(mesh->vertices[v[2]], at) };
    return patch_moved(&patch, leaf->pose->outward);
}

/* What has no patches but points. */
static bool leaf_is_strewn(const struct leaf *leaf)
{
    return leaf->object->kind == OBJECT_SHAPE &&
           !leaf->object->primitive->patches &&
           emitter_points_can(leaf->object->primitive);
}

/* Balls stay in the leaf's own space, flat patches are in the world's. */
static struct patch part_patch(const struct emitters *emitters,
                               const struct leaf *leaf, uint32_t number)
{
    struct patch patches[PATCHES_MAX];
    if (leaf->object->kind == OBJECT_MESH)
        return triangle_patch(leaf, number);
    if (leaf_is_strewn(leaf)) {
        const struct emitter_point *point = &emitters->points.items[number];
        return (struct patch){ .kind = PATCH_POINT,
                               .at = point->at,
                               .area = point->area };
    }
    leaf->object->primitive->patches(leaf->shape, patches);
    if (patches[number].kind == PATCH_BALL)
        return patches[number];
    return patch_moved(&patches[number], leaf->pose->outward);
}

static double growth(const affine *transform)
{
    return fabs(affine_determinant(*transform));
}

/* Of balls under uneven scaling about that. */
static double patch_area(const struct leaf *leaf, const struct patch *patch)
{
    double area = vec3_length(vec3_cross(patch->a, patch->b));
    if (patch->kind == PATCH_POINT)
        return patch->area;
    if (patch->kind == PATCH_BALL)
        return 4 * WARP_PI * patch->radius * patch->radius *
               pow(growth(leaf->pose->outward), 2.0 / 3);
    if (patch->kind == PATCH_DISC)
        return WARP_PI * area;
    return patch->kind == PATCH_TRIANGLE ? area / 2 : area;
}

static void add_part(struct emitters *emitters, const struct leaf *leaf,
                     uint32_t number, double glow)
{
    struct patch patch = part_patch(emitters, leaf, number);
    double power = patch_area(leaf, &patch) * glow;
    if (!(power > 0) || !isfinite(power))
        return;
    emitters->total += power;
    *ARRAY_PUSH(emitters->arena, &emitters->parts) =
        (struct part){ leaf, number };
    *ARRAY_PUSH(emitters->arena, &emitters->sums) = emitters->total;
}

/* Its points, found by many lines if it fills little of its box. */
static void add_points(struct emitters *emitters, const struct leaf *leaf,
                       double glow)
{
    const size_t first = emitters->points.count;
    emitter_points_add(emitters->arena, leaf, LINES, &emitters->points);
    if (emitters->points.count - first < POINTS_FEW &&
        emitters->strewn <= STREWN_MOST / LINES_DENSE) {
        emitters->points.count = first;
        emitter_points_add(emitters->arena, leaf, LINES * LINES_DENSE,
                           &emitters->points);
    }
    emitters->picked[leaf->number] = emitters->points.count > first;
    for (size_t i = first; i < emitters->points.count; i++)
        add_part(emitters, leaf, (uint32_t)i, glow);
}

static void add_shape(struct emitters *emitters, const struct leaf *leaf)
{
    struct patch patches[PATCHES_MAX];
    const struct primitive *primitive = leaf->object->primitive;
    double glow = texture_glow(leaf->look->texture);
    if (glow == 0 || emitters->parts.count + PATCHES_MAX > PARTS_MAX)
        return;
    if (leaf_is_strewn(leaf)) {
        if (emitters->strewn > 0 && emitters->strewn <= STREWN_MOST)
            add_points(emitters, leaf, glow);
        return;
    }
    if (!primitive->patches)
        return;
    int count = primitive->patches(leaf->shape, patches);
    emitters->picked[leaf->number] = true;
    for (int i = 0; i < count; i++)
        add_part(emitters, leaf, (uint32_t)i, glow);
}

static bool mesh_glows(const struct leaf *leaf)
{
    const struct mesh *mesh = leaf->object->mesh;
    bool glows = texture_glow(leaf->look->texture) > 0;
    for (size_t i = 0; i < mesh->texture_count && !glows; i++)
        glows = mesh->textures[i] && texture_glow(mesh->textures[i]) > 0;
    return glows;
}

static void add_mesh(struct emitters *emitters, const struct leaf *leaf)
{
    const struct mesh *mesh = leaf->object->mesh;
    if (!mesh_glows(leaf) ||
        emitters->parts.count + mesh->triangle_count > PARTS_MAX)
        return;
    emitters->picked[leaf->number] = true;
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        uint32_t number = (uint32_t)i;
        double glow = texture_glow(triangle_texture(leaf, number));
        if (glow > 0)
            add_part(emitters, leaf, number, glow);
    }
}

static void add_leaf(void *context, const struct leaf *leaf)
{
    struct emitters *emitters = context;
    const double before = emitters->total;
    if (leaf->object->kind == OBJECT_MESH)
        add_mesh(emitters, leaf);
    else
        add_shape(emitters, leaf);
    if (emitters->total > before)
        *ARRAY_PUSH(emitters->arena, &emitters->shares) =
            (struct emitter_share){ leaf, before, emitters->total - before };
}

static void add_solid(void *context, const struct solid *solid)
{
    if (solid->leaf)
        add_leaf(context, solid->leaf);
    for (size_t i = 0; i < solid->child_count; i++)
        add_solid(context, solid->children[i]);
}

static void count_leaf(void *context, const struct leaf *leaf)
{
    struct emitters *emitters = context;
    emitters->strewn +=
        leaf_is_strewn(leaf) && texture_glow(leaf->look->texture) > 0;
}

static void count_solid(void *context, const struct solid *solid)
{
    if (solid->leaf)
        count_leaf(context, solid->leaf);
    for (size_t i = 0; i < solid->child_count; i++)
        count_solid(context, solid->children[i]);
}

struct emitters *emitters_new(const struct world *world, bool strewn)
{
    struct arena *arena = arena_new(0);
    struct emitters *emitters = ARENA_NEW(arena, struct emitters);
    emitters->arena = arena;
    emitters->picked = ARENA_ARRAY(arena, bool, world_leaf_count(world) + 1);
    if (strewn)
        world_visit(world, count_solid, count_leaf, emitters);
    world_visit(world, add_solid, add_leaf, emitters);
    for (size_t i = 0; i < emitters->shares.count; i++) {
        emitters->shares.items[i].from /= emitters->total;
        emitters->shares.items[i].share /= emitters->total;
    }
    return emitters;
}

void emitters_free(struct emitters *emitters)
{
    if (emitters)
        arena_free(emitters->arena);
}

bool emitters_any(const struct emitters *emitters)
{
    return emitters->parts.count > 0;
}

bool emitter_is_met(const struct emitter_pick *pick,
                    const struct intersection *at)
{
    return at->leaf == pick->leaf &&
           (isinf(pick->distance) ||
            fabs(at->t - pick->distance) <= 1e-5 * (1 + at->t));
}

size_t emitters_shares(const struct emitters *emitters,
                       const struct emitter_share **shares)
{
    *shares = emitters->shares.items;
    return emitters->shares.count;
}

static vec3 patch_point(const struct patch *patch, const double u[2])
{
    double x = u[0], y = u[1];
    if (patch->kind == PATCH_DISC) {
        warp_disc(u, &x, &y);
    } else if (patch->kind == PATCH_TRIANGLE) {
        x = 1 - sqrt(u[0]);
        y = u[1] * (1 - x);
    }
    return vec3_along(vec3_along(patch->at, patch->a, x), patch->b, y);
}

/* 1 - the cosine of the half angle of a ball, seen from the point in the
 * ball's own space; 0 from inside. */
static double ball_rise(const struct patch *ball, vec3 point)
{
    vec3 offset = vec3_sub(ball->at, point);
    double sine2 = ball->radius * ball->radius / vec3_dot(offset, offset);
    if (!(sine2 < 1))
        return 0;
    return sine2 / (1 + sqrt(1 - sine2));
}

/* What a density becomes when the space that `direction` (unit) is in is taken
 * to another: area on the unit sphere grows by |det A| / |A d|^3. */
static double density_moved(double density, const affine *transform,
                            vec3 direction)
{
    double length = vec3_length(affine_direction(transform, direction));
    return density * length * length * length / growth(transform);
}

static double ball_density(const struct leaf *leaf, const struct patch *ball,
                           vec3 point, vec3 direction)
{
    vec3 local = affine_point(leaf->pose->inward, point);
    vec3 there = affine_direction(leaf->pose->inward, direction);
    double rise = ball_rise(ball, local);
    if (!(rise > 0))
        return 0;
    return density_moved(warp_cone_density(rise), leaf->pose->outward,
                         vec3_normalise(there));
}

static bool ball_pick(const struct leaf *leaf, const struct patch *ball,
                      vec3 point, const double u[2], struct emitter_pick *pick)
{
    vec3 local = affine_point(leaf->pose->inward, point);
    vec3 axis = vec3_normalise(vec3_sub(ball->at, local));
    double rise = ball_rise(ball, local);
    if (!(rise > 0))
        return false;
    vec3 there = warp_cone(u, axis, rise);
    pick->direction =
        vec3_normalise(affine_direction(leaf->pose->outward, there));
    pick->distance = (double)INFINITY;
    pick->density =
        density_moved(warp_cone_density(rise), leaf->pose->outward, there);
    return true;
}

static bool patch_pick(const struct patch *patch, double area, vec3 point,
                       const double u[2], struct emitter_pick *pick)
{
    vec3 offset = vec3_sub(patch_point(patch, u), point);
    double distance = vec3_length(offset);
    vec3 normal = vec3_normalise(vec3_cross(patch->a, patch->b));
    if (!(distance > 0))
        return false;
    pick->direction = vec3_scale(offset, 1 / distance);
    pick->distance = distance;
    double cosine = fabs(vec3_dot(normal, pick->direction));
    pick->density = distance * distance / (cosine * area);
    return cosine > 0;
}

/* The way there, whatever else of the leaf is met on it. */
static bool point_pick(const struct leaf *leaf, const struct patch *patch,
                       vec3 point, struct emitter_pick *pick)
{
    vec3 offset = vec3_sub(patch->at, point);
    double distance = vec3_length(offset);
    if (!(distance > 0))
        return false;
    pick->direction = vec3_scale(offset, 1 / distance);
    pick->distance = (double)INFINITY;
    pick->density =
        emitter_points_density(leaf, point, pick->direction) / patch->area;
    return true;
}

bool emitters_pick(const struct emitters *emitters, vec3 point, double which,
                   const double u[2], struct emitter_pick *pick)
{
    double share;
    size_t number =
        draw_share(emitters->sums.items, emitters->sums.count, which, &share);
    const struct part *part = &emitters->parts.items[number];
    struct patch patch = part_patch(emitters, part->leaf, part->number);
    bool there;
    if (patch.kind == PATCH_BALL)
        there = ball_pick(part->leaf, &patch, point, u, pick);
    else if (patch.kind == PATCH_POINT)
        there = point_pick(part->leaf, &patch, point, pick);
    else
        there =
            patch_pick(&patch, patch_area(part->leaf, &patch), point, u, pick);
    pick->leaf = part->leaf;
    pick->density *= share;
    return there && pick->density > 0 && isfinite(pick->density);
}

double emitters_density(const struct emitters *emitters, vec3 point,
                        vec3 direction, const struct intersection *at)
{
    const struct leaf *leaf = at->leaf;
    if (!emitters->picked[leaf->number])
        return 0;
    double glow = texture_glow(at->texture) / emitters->total;
    if (leaf_is_strewn(leaf))
        return glow * emitter_points_density(leaf, point, direction);
    if (leaf->object->kind == OBJECT_SHAPE) {
        struct patch patch = part_patch(emitters, leaf, 0);
        if (patch.kind == PATCH_BALL)
            return glow * patch_area(leaf, &patch) *
                   ball_density(leaf, &patch, point, direction);
    }
    vec3 offset = vec3_sub(at->point, point);
    double cosine = fabs(vec3_dot(at->normal, direction));
    return cosine > 0 ? glow * vec3_dot(offset, offset) / cosine : 0;
}

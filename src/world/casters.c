/* Shadow casters taken apart: see casters.h. */
#include "world/casters.h"

#include "base/memory.h"
#include "scene/primitive.h"

struct taking {
    struct casters *casters;
    bool counting; /* the triangles, before there is room for them */
    bool failed;
    double doubtful_area;
};

static void take_triangle(struct taking *taking,
                          struct caster_triangles *triangles, vec3 a, vec3 b,
                          vec3 c)
{
    struct casters *casters = taking->casters;
    size_t i = triangles->count++;
    const vec3 corner[3] = { a, b, c };
    for (int k = 0; !taking->counting && k < 3; k++) {
        vec3 at = vec3_sub(corner[k], casters->centre);
        triangles->corner[3 * k][i] = (float)at.x;
        triangles->corner[3 * k + 1][i] = (float)at.y;
        triangles->corner[3 * k + 2][i] = (float)at.z;
        double most = fmax(fabs(at.x), fmax(fabs(at.y), fabs(at.z)));
        casters->size = fmax(casters->size, most);
    }
}

/* Both halves of a parallelogram. */
static void take_square(struct taking *taking,
                        struct caster_triangles *triangles, vec3 at, vec3 a,
                        vec3 b)
{
    vec3 beside = vec3_add(at, a), above = vec3_add(at, b);
    take_triangle(taking, triangles, at, beside, above);
    take_triangle(taking, triangles, vec3_add(beside, b), beside, above);
}

/* What is seen of a lamp hides no light of that one. */
static bool leaf_is_other(const struct leaf *leaf)
{
    return leaf->look->looks_like >= 0;
}

/* What is in the box may hide something. Of lines that meet a convex body those
 * that meet another in it are as many as its surface is of the first's. */
static void take_box(struct taking *taking, struct box3 box)
{
    struct caster_triangles *doubtful = &taking->casters->doubtful;
    vec3 d = vec3_sub(box.high, box.low);
    const vec3 edge[3] = { { d.x, 0, 0 }, { 0, d.y, 0 }, { 0, 0, d.z } };
    if (!box3_is_finite(box)) {
        taking->failed = true;
        return;
    }
    taking->doubtful_area += box3_half_area(box);
    for (int k = 0; k < 3; k++) {
        vec3 a = edge[(k + 1) % 3], b = edge[(k + 2) % 3];
        take_square(taking, doubtful, box.low, a, b);
        take_square(taking, doubtful, box.high, vec3_negate(a), vec3_negate(b));
    }
}

static void take_mesh(void *context, const struct leaf *leaf)
{
    struct taking *taking = context;
    const struct mesh *mesh = leaf->object->mesh;
    if (leaf->look->no_shadow)
        return;
    if (!leaf->look->opaque || leaf_is_other(leaf))
        taking->failed = true;
    for (size_t i = 0; !taking->failed && i < mesh->triangle_count; i++)
        take_triangle(taking, &taking->casters->certain,
                      leaf_corner(leaf, i, 0), leaf_corner(leaf, i, 1),
                      leaf_corner(leaf, i, 2));
}

/* The normal of the plane in the world: as a covector goes. */
static void take_space(struct taking *taking, const struct leaf *leaf)
{
    struct casters *casters = taking->casters;
    const struct object *object = leaf->object;
    struct caster_space space;
    if (casters->space_count == CASTER_SPACES) {
        taking->failed = true;
        return;
    }
    object->primitive->half_space(leaf->shape, &space.normal, &space.distance);
    vec3 origin = affine_point(leaf->pose->inward, vec3_make(0, 0, 0));
    space.distance -= vec3_dot(space.normal, origin);
    space.normal = affine_normal(leaf->pose->inward, space.normal);
    casters->spaces[casters->space_count++] = space;
}

/* The flat parts, if it has no others. */
static bool take_patches(struct taking *taking, const struct leaf *leaf)
{
    const struct object *object = leaf->object;
    struct patch patches[PATCHES_MAX];
    if (!object->primitive->patches || !object->primitive->solid)
        return false;
    int count = object->primitive->patches(leaf->shape, patches);
    for (int i = 0; i < count; i++)
        if (patches[i].kind != PATCH_PARALLELOGRAM)
            return false;
    for (int i = 0; i < count; i++) {
        struct patch side = patch_moved(&patches[i], leaf->pose->outward);
        take_square(taking, &taking->casters->certain, side.at, side.a, side.b);
    }
    return true;
}

/* Whether all parts stop all light. */
static bool solid_is_opaque(const struct solid *solid)
{
    if (solid->leaf)
        return solid->leaf->look->opaque;
    for (size_t i = 0; i < solid->child_count; i++)
        if (!solid_is_opaque(solid->children[i]))
            return false;
    return true;
}

static void take_solid(void *context, const struct solid *solid)
{
    struct taking *taking = context;
    const struct leaf *leaf = solid->simple ? solid->leaf : NULL;
    if (leaf && leaf->look->no_shadow)
        return;
    if (!solid_is_opaque(solid)) {
        taking->failed = true;
        return;
    }
    bool plain = leaf && leaf->object->primitive && !leaf_is_other(leaf);
    if (plain && leaf->object->primitive->half_space)
        take_space(taking, leaf);
    else if (!plain || !take_patches(taking, leaf))
        take_box(taking, solid->surface);
}

static bool take_all(struct casters *casters, const struct world *world,
                     bool counting)
{
    struct taking taking = { casters, counting, false, 0 };
    struct box3 bounds = world_bounds(world);
    casters->certain.count = casters->doubtful.count = 0;
    casters->space_count = 0;
    world_visit(world, take_solid, take_mesh, &taking);
    if (taking.doubtful_area > 0)
        casters->doubt = taking.doubtful_area / box3_half_area(bounds);
    return !taking.failed;
}

static void triangles_room(struct caster_triangles *triangles)
{
    for (int k = 0; k < 9; k++)
        triangles->corner[k] =
            memory_new((triangles->count + CASTER_WIDTH) * sizeof(float));
}

static void triangles_free(struct caster_triangles *triangles)
{
    for (int k = 0; k < 9; k++)
        memory_free(triangles->corner[k]);
}

bool casters_new(struct casters *casters, const struct world *world)
{
    *casters = (struct casters){ .size = 0 };
    if (!take_all(casters, world, true))
        return false;
    triangles_room(&casters->certain);
    triangles_room(&casters->doubtful);
    struct box3 bounds = world_bounds(world);
    if (box3_is_finite(bounds))
        casters->centre = vec3_scale(vec3_add(bounds.low, bounds.high), 0.5);
    take_all(casters, world, false);
    return true;
}

void casters_free(struct casters *casters)
{
    triangles_free(&casters->certain);
    triangles_free(&casters->doubtful);
    *casters = (struct casters){ .size = 0 };
}

/* world/: what rays meet in random scenes, against answers found the slow
 * way, straight from the tree of objects. */
#include <stdlib.h>

#include "shapes.h"

#include "base/array.h"
#include "scene/mesh.h"
#include "world/flatten.h"
#include "world/halfspace.h"
#include "world/world.h"

static struct object *shape_object(struct scene *scene, const char *name,
                                   const double *numbers, int count)
{
    struct object *object = object_new(scene->arena, OBJECT_SHAPE, span_none());
    object->primitive = primitive_find(name);
    object->shape = shape_new(scene->arena, name, numbers, count);
    return object;
}

static struct object *node(struct scene *scene, enum object_kind kind,
                           struct object *const *children, size_t count)
{
    struct object *object = object_new(scene->arena, kind, span_none());
    struct object_more *more = object_more(scene->arena, object);
    more->children = ARENA_ARRAY(scene->arena, const struct object *, count);
    for (size_t i = 0; i < count; i++)
        more->children[i] = children[i];
    more->child_count = (unsigned)count;
    return object;
}

static void scene_add(struct scene *scene, const struct object *object)
{
    *ARRAY_PUSH(scene->arena, &scene->objects) = object;
}

static const struct texture *plain_texture(struct scene *scene, double transmit)
{
    struct texture *texture = ARENA_NEW(scene->arena, struct texture);
    struct pigment *pigment = ARENA_NEW(scene->arena, struct pigment);
    struct finish *finish = ARENA_NEW(scene->arena, struct finish);
    *pigment = pigment_default(scene->arena);
    pigment->colour.transmit = transmit;
    *finish = finish_default();
    texture->layers = ARENA_NEW(scene->arena, struct layer);
    texture->layers[0] = (struct layer){ pigment, NULL, finish };
    texture->count = 1;
    return texture;
}

static void move_at_random(struct scene *scene, struct object *object,
                           struct dice *dice)
{
    affine turn = affine_rotation(dice_point(dice, 180));
    affine grow = affine_scaling(vec3_make(dice_between(dice, 0.4, 1.5),
                                           dice_between(dice, 0.4, 1.5),
                                           dice_between(dice, 0.4, 1.5)));
    affine shift = affine_translation(dice_point(dice, 0.8));
    affine all = affine_compose(shift, affine_compose(turn, grow));
    object_move(scene->arena, object, &all);
}

static struct object *random_shape(struct scene *scene, struct dice *dice)
{
    static const struct {
        const char *name;
        int count;
        double numbers[10];
    } shapes[] = {
        { "sphere", 4, { 0, 0, 0, 1 } },
        { "box", 6, { -1, -1, -1, 1, 1, 1 } },
        { "cylinder", 7, { 0, -1, 0, 0, 1, 0, 0.7 } },
        { "cone", 8, { 0, -1, 0, 1, 0, 1, 0, 0.2 } },
        { "torus", 2, { 1, 0.4 } },
        { "plane", 4, { 0, 1, 0, 0.5 } },
        { "quadric", 10, { 1, 0, 1, 0, 0, 0, 0, 0, 0, -0.5 } },
    };
    size_t kind = (size_t)dice_between(dice, 0, 7);
    struct object *object = shape_object(
        scene, shapes[kind].name, shapes[kind].numbers, shapes[kind].count);
    move_at_random(scene, object, dice);
    return object;
}

/* Merges and intersections down to `depth`, some parts turned inside out, some
 * clipped. */
static struct object *random_solid(struct scene *scene, struct dice *dice,
                                   int depth)
{
    struct object *object;
    if (depth == 0 || dice_between(dice, 0, 1) < 0.2) {
        object = random_shape(scene, dice);
    } else {
        struct object *children[12];
        size_t count = (size_t)dice_between(dice, 2, depth > 1 ? 4 : 12);
        for (size_t i = 0; i < count; i++) {
            children[i] = random_solid(scene, dice, depth - 1);
            if (i > 0 && dice_between(dice, 0, 1) < 0.3)
                children[i]->inverse = true;
        }
        object = node(scene,
                      dice_between(dice, 0, 1) < 0.5 ? OBJECT_MERGE
                                                     : OBJECT_INTERSECTION,
                      children, count);
        move_at_random(scene, object, dice);
    }
    return object;
}

/* ---- the slow way ---- */

static bool slow_inside(const struct object *object, vec3 point)
{
    affine inverse;
    assert_true(affine_inverse(*object->maps->own, &inverse));
    vec3 p = affine_point(&inverse, point);
    bool inside = object->kind == OBJECT_INTERSECTION;
    if (object->kind == OBJECT_SHAPE)
        inside = object->primitive->inside(object->shape, p);
    for (size_t i = 0; i < object->more->child_count; i++) {
        bool child = slow_inside(object->more->children[i], p);
        inside = object->kind == OBJECT_INTERSECTION ? inside && child
                                                     : inside || child;
    }
    return inside != object->inverse;
}

enum { SLOW_MAX = 4096 };

struct places {
    double t[SLOW_MAX];
    int count;
};

static void slow_crossings(const struct object *object, struct ray ray,
                           struct places *places)
{
    affine inverse;
    assert_true(affine_inverse(*object->maps->own, &inverse));
    ray.origin = affine_point(&inverse, ray.origin);
    ray.direction = affine_direction(&inverse, ray.direction);
    if (object->kind == OBJECT_SHAPE) {
        struct hits hits = { .count = 0 };
        object->primitive->intersect(object->shape, &ray, &hits);
        for (int i = 0; i < hits.count && places->count < SLOW_MAX; i++)
            if (hits.at[i].t > 0)
                places->t[places->count++] = hits.at[i].t;
    }
    for (size_t i = 0; i < object->more->child_count; i++)
        slow_crossings(object->more->children[i], ray, places);
}

static int compare_double(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Where in and out change along the ray, in order. Places closer than `gap`
 * make it unsure, and false is returned. */
static bool slow_boundaries(const struct object *object, const struct ray *ray,
                            double gap, struct places *out)
{
    static struct places places; /* large; tests have one thread */
    places.count = 0;
    out->count = 0;
    slow_crossings(object, *ray, &places);
    qsort(places.t, (size_t)places.count, sizeof places.t[0], compare_double);
    for (int i = 0; i < places.count; i++) {
        double before = i > 0 ? places.t[i - 1] : 0;
        double after = i + 1 < places.count ? places.t[i + 1] : places.t[i] + 1;
        if (places.t[i] - before < gap || after - places.t[i] < gap)
            return false;
        bool in =
            slow_inside(object, ray_point(ray, (before + places.t[i]) / 2));
        bool out_there =
            slow_inside(object, ray_point(ray, (after + places.t[i]) / 2));
        if (in != out_there && places.t[i] < 1e7)
            out->t[out->count++] = places.t[i];
    }
    return true;
}

/* ---- tests ---- */

struct counted {
    int count;
    double sum;
};

static bool count_crossing(void *context, const struct ray *ray,
                           const struct world_hit *hit)
{
    struct counted *counted = context;
    counted->count++;
    counted->sum += hit->hit.t;
    (void)ray;
    return false;
}

static struct ray random_ray(struct dice *dice)
{
    vec3 from = dice_point(dice, 6), to = dice_point(dice, 1.5);
    return (struct ray){ from, vec3_normalise(vec3_sub(to, from)) };
}

/* The nearest crossing, and all of them by a shadow ray, are the places at
 * which the solid's inside begins or ends. */
static void solids_have_the_boundaries_of_their_insides(void **state)
{
    (void)state;
    static struct places wanted;
    struct dice dice = { 7 };
    int sure = 0, met = 0;
    for (int trial = 0; trial < 150; trial++) {
        struct scene *scene = scene_new(0);
        struct diag diag = { .out = NULL };
        struct object *solid = random_solid(scene, &dice, trial % 4);
        solid->texture = plain_texture(scene, 0.5);
        scene_add(scene, solid);
        struct world *world = world_new(scene, 1, 0, &diag);
        assert_non_null(world);
        for (int i = 0; i < 200; i++) {
            struct ray ray = random_ray(&dice);
            if (!slow_boundaries(solid, &ray, 1e-4, &wanted))
                continue;
            struct intersection at;
            struct counted counted = { 0, 0 };
            bool hit = world_closest(world, &ray, 0, RAY_CAMERA, &at);
            sure++;
            assert_true(hit == (wanted.count > 0));
            if (hit) {
                met++;
                assert_true(fabs(at.t - wanted.t[0]) < 1e-7);
                vec3 outer = vec3_along(at.point, at.normal, 1e-5);
                if (fabs(vec3_dot(at.normal, ray.direction)) > 0.1)
                    assert_false(slow_inside(solid, outer));
            }
            world_occluded(world, &(struct occlusion){ .ray = &ray,
                                                       .tmax = 1e6,
                                                       .light = -1,
                                                       .filter = count_crossing,
                                                       .context = &counted });
            double sum = 0;
            int count = 0;
            for (; count < wanted.count && wanted.t[count] < 1e6; count++)
                sum += wanted.t[count];
            assert_int_equal(counted.count, count);
            assert_true(fabs(counted.sum - sum) <= 1e-6 * (1 + sum));
        }
        world_free(world);
        scene_free(scene);
    }
    assert_true(sure > 10000 && met > 3000);
}

/* A union of many: the nearest of all crossings of all shapes. */
static void crowds_give_the_nearest(void **state)
{
    (void)state;
    static struct places places;
    struct dice dice = { 8 };
    struct scene *scene = scene_new(0);
    struct diag diag = { .out = NULL };
    struct object *all[300];
    for (int i = 0; i < 300; i++) {
        all[i] = random_shape(scene, &dice);
        affine small = affine_scaling(vec3_make(0.1, 0.1, 0.1));
        affine shift = affine_translation(dice_point(&dice, 2));
        small = affine_compose(shift, small);
        if (all[i]->primitive->bounds != primitive_find("plane")->bounds)
            object_move(scene->arena, all[i], &small);
    }
    struct object *crowd = node(scene, OBJECT_UNION, all, 300);
    scene_add(scene, crowd);
    struct world *world = world_new(scene, 1, 0, &diag);
    assert_int_equal(world_leaf_count(world), 300);
    for (int i = 0; i < 3000; i++) {
        struct ray ray = random_ray(&dice);
        struct intersection at;
        bool hit = world_closest(world, &ray, 0, RAY_CAMERA, &at);
        double nearest = 1e7;
        places.count = 0;
        slow_crossings(crowd, ray, &places);
        for (int k = 0; k < places.count; k++)
            nearest = fmin(nearest, places.t[k]);
        assert_true(hit == (nearest < 1e7));
        if (hit)
            assert_true(fabs(at.t - nearest) < 1e-9 * (1 + nearest));
        bool blocked = world_occluded(
            world, &(struct occlusion){
                       .ray = &ray, .tmax = nearest + 1e-3, .light = -1 });
        assert_true(blocked == hit);
        if (nearest > 0.01)
            assert_false(world_occluded(
                world, &(struct occlusion){
                           .ray = &ray, .tmax = nearest - 1e-3, .light = -1 }));
    }
    world_free(world);
    scene_free(scene);
}

static struct mesh *random_mesh(struct scene *scene, struct dice *dice,
                                size_t count)
{
    struct mesh *mesh = ARENA_NEW(scene->arena, struct mesh);
    mesh->vertices = ARENA_ARRAY(scene->arena, vec3, 3 * count);
    mesh->triangles = ARENA_ARRAY(scene->arena, struct mesh_triangle, count);
    mesh->vertex_count = 3 * count;
    mesh->triangle_count = count;
    for (size_t i = 0; i < count; i++) {
        vec3 centre = dice_point(dice, 1);
        for (size_t k = 0; k < 3; k++) {
            mesh->vertices[3 * i + k] = vec3_add(centre, dice_point(dice, 0.2));
            mesh->triangles[i].vertex[k] = (uint32_t)(3 * i + k);
        }
        mesh->triangles[i].normal[0] = MESH_NONE;
        mesh->triangles[i].texture = MESH_NONE;
    }
    assert_int_equal(mesh_prepare(mesh), 0);
    return mesh;
}

static struct object *mesh_object(struct scene *scene, const struct mesh *mesh)
{
    struct object *object = object_new(scene->arena, OBJECT_MESH, span_none());
    object->mesh = mesh;
    return object;
}

/* The nearest of all triangles of all objects; false if an edge is near. */
static bool slow_triangles(struct object *const *objects, size_t count,
                           const struct ray *ray, double *nearest, int *hits)
{
    *nearest = 1e7;
    *hits = 0;
    for (size_t i = 0; i < count; i++) {
        affine inverse;
        assert_true(affine_inverse(*objects[i]->maps->own, &inverse));
        struct ray local = { affine_point(&inverse, ray->origin),
                             affine_direction(&inverse, ray->direction) };
        const struct mesh *mesh = objects[i]->mesh;
        for (size_t k = 0; k < mesh->triangle_count; k++) {
            struct hit hit;
            mesh_refine(mesh, k, &local, &hit);
            double margin = fmin(fmin(hit.u, hit.v), 1 - hit.u - hit.v);
            if (fabs(margin) < 1e-4 || !(fabs(hit.t) < 1e6))
                return false;
            if (margin > 0 && hit.t > 0) {
                *nearest = fmin(*nearest, hit.t);
                ++*hits;
            }
        }
    }
    return true;
}

/* Copied meshes, a shared one as instances, and transparent ones. */
static void triangles_are_hit_exactly(void **state)
{
    (void)state;
    struct dice dice = { 9 };
    for (int trial = 0; trial < 3; trial++) {
        struct scene *scene = scene_new(0);
        struct diag diag = { .out = NULL };
        const struct mesh *small = random_mesh(scene, &dice, 40);
        const struct mesh *big = random_mesh(scene, &dice, 1500);
        const struct texture *glass = plain_texture(scene, 0.5);
        struct object *objects[6];
        for (int i = 0; i < 6; i++) {
            objects[i] = mesh_object(scene, i < 2 ? big : small);
            objects[i]->texture = trial == 1 ? NULL : glass;
            move_at_random(scene, objects[i], &dice);
            affine far = affine_translation(vec3_make(100 * trial, 0, 7));
            object_move(scene->arena, objects[i], &far);
            scene_add(scene, objects[i]);
        }
        struct world *world = world_new(scene, 1, 0, &diag);
        assert_int_equal(world_triangle_count(world), 3160);
        int sure = 0;
        for (int i = 0; i < 1000; i++) {
            struct ray ray = random_ray(&dice);
            ray.origin = vec3_add(ray.origin, vec3_make(100 * trial, 0, 7));
            struct intersection at;
            double nearest;
            int hits;
            if (!slow_triangles(objects, 6, &ray, &nearest, &hits))
                continue;
            sure++;
            assert_true(world_closest(world, &ray, 0, RAY_CAMERA, &at) ==
                        (hits > 0));
            if (hits > 0)
                assert_true(fabs(at.t - nearest) < 1e-5);
            struct counted counted = { 0, 0 };
            bool blocked = world_occluded(
                world, &(struct occlusion){ .ray = &ray,
                                            .tmax = 1e4,
                                            .light = -1,
                                            .filter = count_crossing,
                                            .context = &counted });
            assert_true(blocked == (trial == 1 && hits > 0));
            if (trial != 1)
                assert_int_equal(counted.count, hits);
            if (hits > 0)
                assert_false(world_closest(world, &ray, nearest + 1e-9,
                                           RAY_CAMERA, &at) &&
                             at.t < nearest + 1e-9);
        }
        assert_true(sure > 100);
        world_free(world);
        scene_free(scene);
    }
}

/* `copies` of a mesh, hit as each triangle says, however many rays the world
 * is built for: fewer than triangles, or very many. Returns how many of eight
 * rays were clear of edges. */
static int hit_copies(struct dice *dice, size_t triangles, size_t copies,
                      double camera_rays)
{
    struct scene *scene = scene_new(0);
    struct diag diag = { .out = NULL };
    const struct mesh *mesh = random_mesh(scene, dice, triangles);
    struct object **objects =
        ARENA_ARRAY(scene->arena, struct object *, copies);
    for (size_t i = 0; i < copies; i++) {
        objects[i] = mesh_object(scene, mesh);
        move_at_random(scene, objects[i], dice);
        scene_add(scene, objects[i]);
    }
    struct world *world = world_new(scene, 2, camera_rays, &diag);
    assert_non_null(world);
    assert_int_equal(world_triangle_count(world), triangles * copies);
    int sure = 0;
    for (int i = 0; i < 8; i++) {
        struct ray ray = random_ray(dice);
        struct intersection at;
        double nearest;
        int hits;
        if (!slow_triangles(objects, copies, &ray, &nearest, &hits))
            continue;
        sure++;
        assert_true(world_closest(world, &ray, 0, RAY_CAMERA, &at) ==
                    (hits > 0));
        if (hits > 0)
            assert_true(fabs(at.t - nearest) < 1e-5);
    }
    world_free(world);
    scene_free(scene);
    return sure;
}

static void instances_of_every_size_are_hit(void **state)
{
    (void)state;
    static const size_t sizes[] = { 1, 999, 1000, 1001, 10000 };
    static const double rays[] = { 0, 300, 76800, 1e9 };
    struct dice dice = { 10 };
    int sure = 0;
    for (int i = 0; i < 5; i++)
        for (int k = 0; k < 4; k++) {
            sure += hit_copies(&dice, sizes[i], 2, rays[k]);
            sure += hit_copies(&dice, sizes[i], 25, rays[k]);
        }
    assert_true(sure > 160);
}

/* A closed mesh with an inside takes part in CSG. */
static void meshes_are_cut(void **state)
{
    (void)state;
    static const uint32_t faces[8][3] = { { 0, 2, 4 }, { 2, 1, 4 }, { 1, 3, 4 },
                                          { 3, 0, 4 }, { 2, 0, 5 }, { 1, 2, 5 },
                                          { 3, 1, 5 }, { 0, 3, 5 } };
    static const double ball[] = { 0, 0, 0, 0.8 };
    struct scene *scene = scene_new(0);
    struct diag diag = { .out = NULL };
    struct mesh mesh = { .vertex_count = 6,
                         .triangle_count = 8,
                         .solid = true,
                         .inside_vector = { 0.1, 0.9, 0.3 } };
    vec3 corners[6] = { { 1, 0, 0 },  { -1, 0, 0 }, { 0, 0, 1 },
                        { 0, 0, -1 }, { 0, 1, 0 },  { 0, -1, 0 } };
    struct mesh_triangle triangles[8];
    for (int i = 0; i < 8; i++)
        triangles[i] =
            (struct mesh_triangle){ { faces[i][0], faces[i][1], faces[i][2] },
                                    { MESH_NONE, 0, 0 },
                                    MESH_NONE };
    mesh.vertices = corners;
    mesh.triangles = triangles;
    mesh_prepare(&mesh);
    struct object *parts[2] = { mesh_object(scene, &mesh),
                                shape_object(scene, "sphere", ball, 4) };
    struct object *cut = node(scene, OBJECT_INTERSECTION, parts, 2);
    cut->texture = plain_texture(scene, 1);
    scene_add(scene, cut);
    struct world *world = world_new(scene, 1, 0, &diag);
    struct ray x = { { -5, 0.01, 0.02 }, { 1, 0, 0 } };
    struct intersection at;
    assert_true(world_closest(world, &x, 0, RAY_CAMERA, &at));
    assert_true(fabs(at.t - (5 - sqrt(0.64 - 0.0005))) < 1e-9);
    assert_true(at.leaf->object == parts[1]);
    struct ray diagonal = { { -5, 5, 5 }, { 1, -1, -1 } };
    diagonal.direction = vec3_normalise(diagonal.direction);
    assert_true(world_closest(world, &diagonal, 0, RAY_CAMERA, &at));
    assert_true(at.leaf->object == parts[0]);
    assert_true(fabs(at.point.x + 1.0 / 3) < 1e-9);
    world_free(world);
    scene_free(scene);
}

static void note_leaf(void *context, const struct leaf *leaf)
{
    const struct leaf **last = context;
    *last = leaf;
}

/* Flags, lights in unions, what looks like a light, where one is inside. */
static void properties_come_down_the_tree(void **state)
{
    (void)state;
    static const double ball[] = { 0, 0, 0, 1 };
    struct scene *scene = scene_new(0);
    struct diag diag = { .out = NULL };
    struct light light = light_default();
    struct object *bulb = shape_object(scene, "sphere", ball, 4);
    struct object *lamp = object_new(scene->arena, OBJECT_LIGHT, span_none());
    struct object *globe = shape_object(scene, "sphere", ball, 4);
    struct interior glass = interior_default();
    light.location = vec3_make(0, 0, 5);
    affine there = affine_translation(light.location);
    object_move(scene->arena, bulb, &there);
    light.looks_like = bulb;
    lamp->light = &light;
    struct object *both[2] = { lamp, globe };
    struct object *all = node(scene, OBJECT_UNION, both, 2);
    all->no_image = true;
    object_more(scene->arena, all)->interior = &glass;
    all->hollow = all->has_hollow = true;
    affine up = affine_translation(vec3_make(0, 10, 0));
    object_move(scene->arena, all, &up);
    scene_add(scene, all);
    struct world *world = world_new(scene, 1, 0, &diag);
    size_t count;
    const struct light *lights = world_lights(world, &count);
    assert_int_equal(count, 1);
    assert_true(lights[0].location.y == 10 && lights[0].location.z == 5);

    struct ray z = { { 0, 10, -5 }, { 0, 0, 1 } };
    struct intersection at;
    assert_false(world_closest(world, &z, 0, RAY_CAMERA, &at));
    assert_true(world_closest(world, &z, 0, RAY_REFLECTION, &at));
    assert_true(at.t == 4 && at.leaf->look->interior == &glass &&
                at.leaf->look->hollow);
    assert_true(world_closest(world, &z, 6.5, RAY_REFLECTION, &at));
    assert_true(fabs(at.t - 9) < 1e-12 && at.leaf->look->looks_like == 0);
    assert_false(world_occluded(
        world, &(struct occlusion){ .ray = &z, .tmin = 6.5, .tmax = 20 }));
    assert_false(world_occluded(
        world,
        &(struct occlusion){ .ray = &z, .tmin = 6.5, .tmax = 20, .light = 1 }));

    const struct leaf *inside = NULL;
    world_containing(world, vec3_make(0, 10.5, 0), note_leaf, &inside);
    assert_true(inside && inside->object == globe);
    inside = NULL;
    world_containing(world, vec3_make(0, 11.5, 0), note_leaf, &inside);
    assert_null(inside);
    world_free(world);
    scene_free(scene);
}

/* Random planes: bounded or not, no point of the body is left out. */
static void polyhedra_are_bounded(void **state)
{
    (void)state;
    struct dice dice = { 11 };
    int bounded = 0, open = 0;
    for (int trial = 0; trial < 300; trial++) {
        struct halfspace planes[12];
        int count = (int)dice_between(&dice, 2, 12);
        struct box3 region = box3_infinite();
        if (trial % 3 == 0)
            region.low.y = -0.5;
        for (int i = 0; i < count; i++)
            planes[i] =
                (struct halfspace){ vec3_normalise(dice_point(&dice, 1)),
                                    dice_between(&dice, 0.1, 1) };
        struct box3 box = halfspaces_box(planes, count, region);
        bounded += box3_is_finite(box);
        open += !box3_is_finite(box);
        for (int i = 0; i < 2000; i++) {
            vec3 p = dice_point(&dice, i % 2 ? 2 : 50);
            bool inside = box3_contains(region, p);
            for (int k = 0; k < count && inside; k++)
                inside = vec3_dot(planes[k].normal, p) <= planes[k].distance;
            if (inside)
                assert_true(box3_contains(box, p));
        }
    }
    assert_true(bounded > 30 && open > 30);
}

/* bounded_by: what misses the bound is not seen, the inside stays. */
static void bounds_hide_what_misses_them(void **state)
{
    (void)state;
    static const double tube[] = { 1, 0, 1, 0, 0, 0, 0, 0, 0, -1 };
    static const double ball[] = { 0, 0, 0, 0.5 };
    struct scene *scene = scene_new(0);
    struct diag diag = { .out = NULL };
    struct object *endless = shape_object(scene, "quadric", tube, 10);
    struct clip bound = { shape_object(scene, "sphere", ball, 4),
                          affine_identity() };
    object_more(scene->arena, endless)->bounds = &bound;
    object_more(scene->arena, endless)->bound_count = 1;
    affine up = affine_translation(vec3_make(0, 10, 0));
    object_move(scene->arena, endless, &up);
    scene_add(scene, endless);
    struct world *world = world_new(scene, 1, 0, &diag);
    struct intersection at;
    struct ray through = { { -5, 10.4, 0 }, { 1, 0, 0 } };
    struct ray beside = { { -5, 10.6, 0 }, { 1, 0, 0 } };
    assert_true(world_closest(world, &through, 0, RAY_CAMERA, &at));
    assert_true(fabs(at.t - 4) < 1e-12);
    assert_false(world_closest(world, &beside, 0, RAY_CAMERA, &at));
    assert_true(world_occluded(
        world, &(struct occlusion){ .ray = &through, .tmax = 9, .light = -1 }));
    assert_false(world_occluded(
        world, &(struct occlusion){ .ray = &beside, .tmax = 9, .light = -1 }));
    assert_true(box3_is_finite(world_bounds(world)));
    world_free(world);
    scene_free(scene);
}

static void expect_failure(struct scene *scene, const char *message)
{
    char text[1000] = "";
    FILE *out = fmemopen(text, sizeof text - 1, "w");
    struct diag diag = { .out = out };
    struct flat flat = { .arena = arena_new(0),
                         .diag = &diag,
                         .node_limit = 10000 };
    assert_false(flatten_scene(&flat, scene));
    arena_free(flat.arena);
    fclose(out);
    assert_non_null(strstr(text, message));
    assert_int_equal(diag.errors, 1);
    scene_free(scene);
}

/* A few lines of a scene can ask for 2^40 objects, or for very deep ones. */
static void endless_scenes_are_refused(void **state)
{
    (void)state;
    static const double ball[] = { 0, 0, 0, 1 };
    for (int kind = OBJECT_UNION; kind <= OBJECT_INTERSECTION; kind++) {
        struct scene *scene = scene_new(0);
        struct object *object = shape_object(scene, "sphere", ball, 4);
        for (int i = 0; i < 40; i++) {
            struct object *twice[2] = { object, object };
            object = node(scene, (enum object_kind)kind, twice, 2);
        }
        scene_add(scene, object);
        expect_failure(scene, "too many objects");
        scene = scene_new(0);
        object = shape_object(scene, "sphere", ball, 4);
        for (int i = 0; i < 100000; i++)
            object = node(scene, (enum object_kind)kind, &object, 1);
        scene_add(scene, object);
        expect_failure(scene, "nested too deep");
    }
}

/* Up to 16 rays close together, one of them no ray, find what each finds by
 * itself. Returns how many met something. */
static int expect_the_same(const struct world *world, struct dice *dice)
{
    struct ray rays[WORLD_RAYS], first = random_ray(dice);
    struct rays together;
    struct world_hit hit[WORLD_RAYS];
    struct intersection at, alone;
    struct rays_span span;
    unsigned count = 1 + (unsigned)dice_between(dice, 0, WORLD_RAYS - 1e-9);
    int hits = 0;
    memset(&together, 0xff, sizeof together); /* NaN: nobody's lanes */
    memset(&span, 0xff, sizeof span);
    for (unsigned i = 0; i < count; i++) {
        rays[i] = first;
        span.near[i] = dice_between(dice, 0, 1);
        span.far[i] = dice_between(dice, 0, 1) < 0.5
                          ? (double)INFINITY
                          : dice_between(dice, 0, 10);
        rays[i].direction =
            vec3_normalise(vec3_add(first.direction, dice_point(dice, 0.05)));
    }
    rays[count / 2].direction.x = (double)NAN;
    rays[count / 3].direction.y = -1e-30;
    for (unsigned i = 0; i < count; i++)
        rays_set(&together, (int)i, rays[i].origin, rays[i].direction);
    const double nobodys = (double)NAN;
    for (unsigned i = count; i < WORLD_RAYS; i++)
        rays_set(&together, (int)i, vec3_make(nobodys, nobodys, nobodys),
                 vec3_make(nobodys, nobodys, nobodys));
    world_closest_many(world, &together, &span, count, RAY_CAMERA, hit);
    for (unsigned i = 0; i < count; i++) {
        bool met = world_within(world, &rays[i], span.near[i], span.far[i],
                                RAY_CAMERA, &alone);
        assert_int_equal(hit[i].leaf != NULL, met);
        hits += met;
        if (!met)
            continue;
        world_describe(&rays[i], &hit[i], &at);
        assert_true(at.t == alone.t && at.leaf == alone.leaf &&
                    at.normal.x == alone.normal.x);
    }
    return hits;
}

/* The same on the way to a lamp, for those of random bits. */
static void expect_the_same_shadows(const struct world *world,
                                    struct dice *dice)
{
    struct occlusions ways = { .light = -1 };
    struct ray first = random_ray(dice);
    unsigned lanes = (unsigned)dice_between(dice, 0, 0x10000 - 1e-9);
    for (int i = 0; i < RAY_LANES; i++) {
        vec3 to = vec3_add(first.direction, dice_point(dice, 0.05));
        if (i == 3)
            to.x = -1e-30;
        rays_set(&ways.rays, i, first.origin, vec3_normalise(to));
        ways.span.near[i] = dice_between(dice, 0, 1);
        ways.span.far[i] = dice_between(dice, 0, 20);
    }
    unsigned blocked = world_occluded_many(world, &ways, lanes).dark;
    for (int i = 0; i < RAY_LANES; i++) {
        struct ray ray = rays_at(&ways.rays, i);
        const struct occlusion way = { .ray = &ray,
                                       .tmin = ways.span.near[i],
                                       .tmax = ways.span.far[i],
                                       .light = -1 };
        bool alone = (lanes >> i & 1) && world_occluded(world, &way);
        assert_int_equal(blocked >> i & 1, alone);
    }
}

static void rays_together_are_as_alone(void **state)
{
    (void)state;
    struct dice dice = { 11 };
    for (int trial = 0; trial < 4; trial++) {
        struct scene *scene = scene_new(0);
        struct diag diag = { .out = NULL };
        /* Copied, shared by instances, hidden from the camera; solids. */
        const struct mesh *small = random_mesh(scene, &dice, 60);
        const struct mesh *big = random_mesh(scene, &dice, 1500);
        for (int i = 0; i < 5; i++) {
            struct object *mesh = mesh_object(scene, i < 3 ? big : small);
            mesh->no_image = i == 3;
            move_at_random(scene, mesh, &dice);
            scene_add(scene, mesh);
        }
        for (int i = 0; i < 6 * trial; i++)
            scene_add(scene, random_shape(scene, &dice));
        struct world *world = world_new(scene, 1, 0, &diag);
        int hits = 0;
        for (int i = 0; i < 500; i++)
            hits += expect_the_same(world, &dice);
        assert_true(hits > 500);
        for (int i = 0; i < 500; i++)
            expect_the_same_shadows(world, &dice);
        world_free(world);
        scene_free(scene);
    }
}

/* Trees of solids, of which every third is clipped and every fourth bounded. */
static void rays_together_meet_trees_as_alone(void **state)
{
    (void)state;
    struct dice dice = { 12 };
    int hits = 0;
    for (int trial = 0; trial < 60; trial++) {
        struct scene *scene = scene_new(0);
        struct diag diag = { .out = NULL };
        for (int i = 0; i <= trial % 3; i++) {
            struct object *solid = random_solid(scene, &dice, trial % 4);
            struct clip *limit = ARENA_NEW(scene->arena, struct clip);
            limit->object = random_solid(scene, &dice, 1);
            limit->transform = affine_identity();
            if (trial % 3 == 1) {
                object_more(scene->arena, solid)->clips = limit;
                object_more(scene->arena, solid)->clip_count = 1;
            } else if (trial % 4 == 1) {
                object_more(scene->arena, solid)->bounds = limit;
                object_more(scene->arena, solid)->bound_count = 1;
            }
            scene_add(scene, solid);
        }
        struct world *world = world_new(scene, 1, 0, &diag);
        assert_non_null(world);
        for (int i = 0; i < 100; i++) {
            hits += expect_the_same(world, &dice);
            expect_the_same_shadows(world, &dice);
        }
        world_free(world);
        scene_free(scene);
    }
    assert_true(hits > 5000);
}

/* Rays along planes, on surfaces, of no length, beyond the world. */
static void odd_rays_do_no_harm(void **state)
{
    (void)state;
    static const double ground[] = { 0, 1, 0, 0 }, ball[] = { 0, 1, 0, 1 };
    struct scene *scene = scene_new(0);
    struct diag diag = { .out = NULL };
    scene_add(scene, shape_object(scene, "plane", ground, 4));
    scene_add(scene, shape_object(scene, "sphere", ball, 4));
    struct world *world = world_new(scene, 1, 0, &diag);
    struct ray rays[] = {
        { { 0, 0, 0 }, { 1, 0, 0 } },
        { { 0, 0, 0 }, { 0, 0, 0 } },
        { { (double)NAN, 0, 0 }, { 0, 1, 0 } },
        { { 0, 1, 0 }, { (double)NAN, 0, 0 } },
        { { 0, 1, 0 }, { HUGE_VAL, 0, 0 } },
        { { 1e300, 1e300, 1e300 }, { 0, -1, 0 } },
        { { 0, 2e7, 0 }, { 0, -1, 0 } },
    };
    for (size_t i = 0; i < sizeof rays / sizeof *rays; i++) {
        struct intersection at;
        assert_false(world_closest(world, &rays[i], 1e-6, RAY_CAMERA, &at));
        assert_false(world_occluded(world, &(struct occlusion){ .ray = &rays[i],
                                                                .tmin = 1e-6,
                                                                .tmax = 1e7,
                                                                .light = -1 }));
    }
    world_free(world);
    scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(solids_have_the_boundaries_of_their_insides),
        cmocka_unit_test(crowds_give_the_nearest),
        cmocka_unit_test(triangles_are_hit_exactly),
        cmocka_unit_test(instances_of_every_size_are_hit),
        cmocka_unit_test(meshes_are_cut),
        cmocka_unit_test(properties_come_down_the_tree),
        cmocka_unit_test(polyhedra_are_bounded),
        cmocka_unit_test(bounds_hide_what_misses_them),
        cmocka_unit_test(endless_scenes_are_refused),
        cmocka_unit_test(rays_together_are_as_alone),
        cmocka_unit_test(rays_together_meet_trees_as_alone),
        cmocka_unit_test(odd_rays_do_no_harm),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

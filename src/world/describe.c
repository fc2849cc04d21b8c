/* What there is to know of a crossing: see describe.h. */
#include "world/describe.h"

#include <string.h>

#include "world/query.h"
#include "scene/mesh.h"
#include "scene/primitive.h"

/* Of tiny or huge vectors, which would lose their length. */
static vec3 unit_scaled(vec3 v)
{
    double most = fmax(fabs(v.x), fmax(fabs(v.y), fabs(v.z)));
    if (!(most > 0) || !isfinite(most))
        return vec3_make(0, 0, 0);
    return vec3_normalise(vec3_make(v.x / most, v.y / most, v.z / most));
}

static inline vec3 unit(vec3 v)
{
    double square = vec3_dot(v, v);
    if (square > 1e-200 && square < 1e200)
        return vec3_scale(v, 1 / sqrt(square));
    return unit_scaled(v);
}

/* In the object's space, of any length. */
static inline vec3 leaf_normal(const struct leaf *leaf, vec3 point,
                               const struct hit *hit)
{
    const struct object *object = leaf->object;
    if (object->kind == OBJECT_MESH)
        return mesh_normal(object->mesh, (size_t)hit->part, hit->u, hit->v);
    if (leaf_is_moved(leaf))
        point = affine_point(leaf->pose->inward, point);
    if (object->primitive->normal_placed)
        return object->primitive->normal_placed(
            leaf->shape, &point, hit,
            leaf_is_moved(leaf) ? leaf->pose->inward : NULL);
    return object->primitive->normal(leaf->shape, &point, hit);
}

/* Of what was hit of a shape or a mesh whose normals are interpolated there; 0:
 * they are not. */
static vec3 leaf_face(const struct leaf *leaf, const struct hit *hit)
{
    const struct object *object = leaf->object;
    if (object->kind == OBJECT_MESH) {
        if (object->mesh->triangles[hit->part].normal[0] != MESH_NONE)
            return mesh_face(object->mesh, (size_t)hit->part);
    } else if (object->primitive->face) {
        return object->primitive->face(leaf->shape, hit);
    }
    return vec3_make(0, 0, 0);
}

/* The normal of a facet whose interpolated one is known; of other shapes they
 * are the same. */
static inline vec3 face_unit(const struct leaf *leaf, const struct hit *hit,
                             vec3 normal)
{
    vec3 face = leaf_face(leaf, hit);
    if (vec3_dot(face, face) == 0)
        return normal;
    if (leaf_is_moved(leaf))
        face = affine_normal(leaf->pose->inward, face);
    face = unit(face);
    if (!(vec3_dot(face, face) > 0))
        return normal;
    return vec3_dot(face, normal) < 0 ? vec3_negate(face) : face;
}

static struct world_coat outer_coat(const struct leaf *leaf, int part)
{
    const struct world_coat usual = { leaf->look->texture,
                                      leaf->look->to_texture,
                                      leaf->look->from_texture };
    if (leaf->object->kind != OBJECT_MESH)
        return usual;
    const struct mesh *mesh = leaf->object->mesh;
    uint32_t number = mesh->triangles[part].texture;
    if (number >= mesh->texture_count || !mesh->textures[number])
        return usual;
    return (struct world_coat){ mesh->textures[number], leaf->pose->inward,
                                leaf->pose->outward };
}

/* The outside of a mesh's flat triangle is where its corners turn to the left,
 * of a smooth one where its normals are (measured); see also mesh.h. */
static bool comes_from_inside(const struct leaf *leaf, int part, vec3 face,
                              vec3 direction)
{
    const struct object *object = leaf->object;
    if (object->kind != OBJECT_MESH ||
        object->mesh->triangles[part].normal[0] != MESH_NONE)
        return vec3_dot(face, direction) > 0;
    face = mesh_face(object->mesh, (size_t)part);
    if (leaf_is_moved(leaf))
        face = affine_normal(leaf->pose->inward, face);
    return (vec3_dot(face, direction) < 0) != object->mesh->turned;
}

static inline struct world_coat coat_at(const struct leaf *leaf, int part,
                                        vec3 face, vec3 direction)
{
    const struct leaf_inner *inner = leaf->look->inner;
    if (inner && comes_from_inside(leaf, part, face, direction))
        return (struct world_coat){ inner->texture, &inner->to_texture,
                                    &inner->from_texture };
    return outer_coat(leaf, part);
}

/* All but the point and the normal: what depends on them and on the part. */
static inline void describe_rest(const struct ray *ray, const struct leaf *leaf,
                                 const struct hit *hit,
                                 struct intersection *out)
{
    vec3 face = face_unit(leaf, hit, out->normal);
    struct world_coat coat = coat_at(leaf, hit->part, face, ray->direction);
    out->face = face;
    out->texture = coat.texture;
    out->to_texture = coat.to_texture;
    out->from_texture = coat.from_texture;
}

/* Of a unit normal, or of 0 where there is none. */
static inline vec3 normal_outward(const struct leaf *leaf, vec3 normal,
                                  vec3 direction)
{
    if (!(vec3_dot(normal, normal) > 0))
        normal = vec3_negate(direction);
    return leaf->look->inverse ? vec3_negate(normal) : normal;
}

void describe_hit(const struct ray *ray, const struct leaf *leaf,
                  const struct hit *hit, struct intersection *out)
{
    /* Kept at hand: what was just stored is read back late. */
    vec3 point = ray_point(ray, hit->t);
    vec3 normal = leaf_normal(leaf, point, hit);
    out->t = hit->t;
    out->point = point;
    out->leaf = leaf;
    out->part = hit->part;
    if (leaf_is_moved(leaf))
        normal = affine_normal(leaf->pose->inward, normal);
    out->normal = normal_outward(leaf, unit(normal), ray->direction);
    describe_rest(ray, leaf, hit, out);
}

void world_describe(const struct ray *ray, const struct world_hit *hit,
                    struct intersection *out)
{
    struct hit found = hit->hit;
    query_refine(ray, hit->leaf, &found);
    describe_hit(ray, hit->leaf, &found, out);
}

CLONES static void points_along(const struct rays *restrict rays,
                                const double *restrict t,
                                double (*restrict points)[RAY_LANES])
{
    for (unsigned i = 0; i < RAY_LANES; i++)
        lane_put(points, i,
                 vec3_along(rays_origin(rays, (int)i),
                            rays_direction(rays, (int)i), t[i]));
}

/* What `unit` makes of those that need no scaling for it; the others stay. */
CLONES static void normals_unit(double (*normals)[RAY_LANES],
                                lane_flag *restrict usual)
{
    for (unsigned i = 0; i < RAY_LANES; i++) {
        vec3 v = lane_get(normals, i);
        double square = vec3_dot(v, v), scale = 1 / sqrt(square);
        bool is = (square > 1e-200) & (square < 1e200);
        scale = is ? scale : 1;
        usual[i] = is ? -1 : 0;
        lane_put(normals, i, vec3_scale(v, scale));
    }
}

/* Those of any length. */
static void faces_raw(const struct rays *rays, const struct world_hit *hits,
                      unsigned lanes, struct world_faces *faces)
{
    LANE_LINES double t[RAY_LANES] = { 0 };
    for (unsigned each = lanes; each; each &= each - 1) {
        unsigned i = (unsigned)__builtin_ctz(each);
        t[i] = hits[i].hit.t;
    }
    points_along(rays, t, faces->point);
    memset(faces->normal, 0, sizeof faces->normal);
    for (; lanes; lanes &= lanes - 1) {
        unsigned i = (unsigned)__builtin_ctz(lanes);
        const struct leaf *leaf = hits[i].leaf;
        const struct ray ray = rays_at(rays, (int)i);
        struct hit *hit = &faces->hit[i];
        *hit = hits[i].hit;
        query_refine(&ray, leaf, hit);
        vec3 normal = leaf_normal(leaf, lane_get(faces->point, i), hit);
        if (leaf_is_moved(leaf))
            normal = affine_normal(leaf->pose->inward, normal);
        lane_put(faces->normal, i, normal);
    }
}

void world_face_many(const struct rays *rays, const struct world_hit *hits,
                     unsigned lanes, struct world_faces *faces)
{
    LANE_LINES lane_flag usual[RAY_LANES];
    faces_raw(rays, hits, lanes, faces);
    normals_unit(faces->normal, usual);
    for (; lanes; lanes &= lanes - 1) {
        unsigned i = (unsigned)__builtin_ctz(lanes);
        const struct leaf *leaf = hits[i].leaf;
        if (usual[i] && !leaf->look->inverse)
            continue;
        vec3 normal = lane_get(faces->normal, i);
        if (!usual[i])
            normal = unit_scaled(normal);
        lane_put(faces->normal, i,
                 normal_outward(leaf, normal, rays_direction(rays, (int)i)));
    }
}

vec3 world_face_side(const struct leaf *leaf, const struct world_faces *faces,
                     unsigned i)
{
    return face_unit(leaf, &faces->hit[i], lane_get(faces->normal, i));
}

struct world_coat world_face_coat(const struct leaf *leaf,
                                  const struct world_faces *faces, unsigned i,
                                  vec3 direction)
{
    return coat_at(leaf, faces->hit[i].part, world_face_side(leaf, faces, i),
                   direction);
}

void world_describe_face(const struct ray *ray, const struct leaf *leaf,
                         const struct world_faces *faces, unsigned i,
                         struct intersection *out)
{
    out->t = faces->hit[i].t;
    out->point = lane_get(faces->point, i);
    out->leaf = leaf;
    out->part = faces->hit[i].part;
    out->normal = lane_get(faces->normal, i);
    describe_rest(ray, leaf, &faces->hit[i], out);
}

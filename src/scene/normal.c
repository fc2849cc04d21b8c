/* Normals: bumps that exist only in the shading. All was measured with POV-Ray
 * 3.7: the tilt is computed in the pattern's own space, so that a texture's
 * bumps grow with it when it is scaled. */
#include <float.h>

#include "base/clones.h"
#include "scene/image_map.h"
#include "scene/map_entry.h"
#include "scene/material.h"
#include "scene/spots.h"

/* Between two entries a cubic with their heights and slopes at its ends. */
static double slope_height(const struct slope_map *map, double value)
{
    const struct slope_entry *entries = map->entries;
    struct map_place place =
        map_place_of(&entries[0].value, sizeof entries[0], map->count, value);
    const struct slope_entry *b = &entries[place.entry], *a = b - 1;
    if (place.share >= 1 || place.entry == 0)
        return b->height;
    double t = place.share, s = 1 - t;
    return s * s * (1 + 2 * t) * a->height + t * t * (1 + 2 * s) * b->height +
           s * t * (s * a->slope - t * b->slope);
}

enum { CORNERS = 4, SLOPES_MAX = SPOTS_MAX / CORNERS };

/* The value's slope by differences along the corners of a tetrahedron; where
 * the value is linear this is 2/15 of its gradient for whatever accuracy. Of so
 * many points from the first on, at most SLOPES_MAX. */
static void normal_slopes(const struct normal *normal,
                          const struct spots *points, int first, int count,
                          vec3 *slopes)
{
    static const vec3 corners[CORNERS] = {
        { 0.94280904158206336, -1.0 / 3, 0 },
        { -0.47140452079103168, -1.0 / 3, 0.81649658092772603 },
        { -0.47140452079103168, -1.0 / 3, -0.81649658092772603 },
        { 0, 1, 0 },
    };
    struct spots at;
    double values[SPOTS_MAX];
    at.count = 0;
    for (int k = 0; k < count * CORNERS; k++)
        spots_add(&at, vec3_along(spots_at(points, first + k / CORNERS),
                                  corners[k % CORNERS], normal->accuracy));
    pattern_values_at(&normal->pattern, &at, values);
    for (int k = 0; k < count; k++) {
        vec3 sum = { 0, 0, 0 };
        for (int i = 0; i < CORNERS; i++) {
            double value = values[k * CORNERS + i];
            sum = vec3_along(
                sum, corners[i],
                normal->slopes ? slope_height(normal->slopes, value) : value);
        }
        slopes[first + k] = vec3_scale(sum, 0.1 / normal->accuracy);
    }
}

/* The unit normal in the pattern's space: by the cofactors of the map there,
 * which are its inverse transpose up to a factor; *length is what it has by the
 * inverse transpose. */
static vec3 normal_into_pattern(const struct cofactors *map, vec3 normal,
                                double *length)
{
    vec3 local = { vec3_dot(map->row[0], normal), vec3_dot(map->row[1], normal),
                   vec3_dot(map->row[2], normal) };
    *length = vec3_length(local) / fabs(map->determinant);
    return vec3_normalise(map->determinant < 0 ? vec3_negate(local) : local);
}

/* Where a normal is bent: in the pattern's own space, and on which surface. */
struct bend {
    vec3 point, normal;
    const struct uv_source *surface;
    double height; /* how long the normal is for bumps that are not scaled, by
                    * this pattern or those around it; 0: they are */
};

/* As long as bumps want it. */
static inline vec3 normal_raised(vec3 normal, double height)
{
    return vec3_scale(normal, height != 0 ? height : 1);
}

static vec3 normal_bent(const struct normal *perturbation,
                        const struct bend *around);

static vec3 entry_normal(const struct normal_entry *entry,
                         const struct bend *at)
{
    if (!entry->normal)
        return normal_raised(at->normal, at->height);
    struct bend around = *at;
    around.point =
        pattern_start(&entry->normal->pattern, at->point, at->surface);
    return normal_bent(entry->normal, &around);
}

static vec3 average_normal(const struct normal_map *map, const struct bend *at)
{
    vec3 sum = { 0, 0, 0 };
    for (size_t i = 0; i < map->count; i++)
        sum = vec3_along(sum, entry_normal(&map->entries[i], at),
                         map->entries[i].value);
    return sum;
}

/* What the pattern picks of other normals, in its own space. */
static vec3 map_normal(const struct normal *perturbation, const struct bend *at)
{
    const struct pattern_kind *kind = perturbation->pattern.kind;
    const struct normal_map *map = perturbation->map;
    const struct normal_entry *entries = map->entries;
    if (kind->average)
        return average_normal(map, at);
    double value = pattern_value_at(&perturbation->pattern, at->point);
    struct map_place place =
        map_place_of(&entries[0].value, sizeof entries[0], map->count, value);
    const struct normal_entry *entry = &entries[place.entry];
    vec3 high = entry_normal(entry, at);
    if (place.share >= 1 || kind->blocks)
        return high;
    return vec3_mix(entry_normal(entry - 1, at), high, place.share);
}

/* What bends the normals, which have no map, for amount 1; all of it is in the
 * pattern's own space. */
static void normal_tilts_at(const struct normal *perturbation,
                            const struct spots *points,
                            const struct spots *normals, vec3 *tilts)
{
    const struct pattern *pattern = &perturbation->pattern;
    const int count = points->count;
    if (perturbation->bumps) {
        for (int i = 0; i < count; i++)
            tilts[i] = image_map_tilt(perturbation->bumps, spots_at(points, i),
                                      spots_at(normals, i));
    } else if (pattern->kind->perturbations && !perturbation->slopes) {
        pattern->kind->perturbations(pattern, points, tilts);
    } else if (pattern->kind->perturbation && !perturbation->slopes) {
        for (int i = 0; i < count; i++)
            tilts[i] = pattern->kind->perturbation(pattern, spots_at(points, i),
                                                   spots_at(normals, i));
    } else {
        for (int i = 0; i < count; i += SLOPES_MAX)
            normal_slopes(perturbation, points, i,
                          count - i < SLOPES_MAX ? count - i : SLOPES_MAX,
                          tilts);
        for (int i = 0; i < count; i++)
            tilts[i] = vec3_negate(tilts[i]);
    }
}

static bool normal_is_full(const struct normal *perturbation)
{
    const struct pattern_kind *kind = perturbation->pattern.kind;
    return kind && kind->full;
}

static double normal_amount(const struct normal *perturbation)
{
    return normal_is_full(perturbation) ? 1 : perturbation->amount;
}

/* Whether its bumps are as high however they are scaled; facets have no height
 * (measured). */
static bool normal_is_unscaled(const struct normal *perturbation)
{
    return perturbation->level && !normal_is_full(perturbation);
}

static vec3 normal_tilted(const struct normal *perturbation,
                          const struct bend *at)
{
    if (perturbation->map)
        return map_normal(perturbation, at);
    const struct spots point = spots_of(at->point);
    const struct spots normal = spots_of(at->normal);
    vec3 tilt;
    normal_tilts_at(perturbation, &point, &normal, &tilt);
    return vec3_along(normal_raised(at->normal, at->height), tilt,
                      normal_amount(perturbation));
}

bool normal_tilts(const struct normal *perturbation)
{
    return perturbation->pattern.kind || perturbation->bumps;
}

static bool normal_spatial(const struct normal *normal, int *budget)
{
    const struct normal_map *map = normal->map;
    if (--*budget < 0 || !pattern_is_of_space(&normal->pattern, budget))
        return false;
    for (size_t i = 0; map && i < map->count; i++)
        if (map->entries[i].normal &&
            !normal_spatial(map->entries[i].normal, budget))
            return false;
    return true;
}

bool normal_is_of_space(const struct normal *perturbation)
{
    int budget = 1000;
    return normal_spatial(perturbation, &budget);
}

static bool normal_is_level(const struct normal *perturbation)
{
    return !normal_tilts(perturbation) ||
           (normal_amount(perturbation) == 0 && !perturbation->map);
}

/* The way into the pattern's own space. */
struct normal_space {
    const affine *inward;
    const struct cofactors *cofactors;
    affine warped; /* what they are of a pattern with warps */
    struct cofactors of_warped;
};

static void normal_space_of(struct normal_space *space,
                            const struct pattern *pattern)
{
    space->inward = &pattern->inverse;
    space->cofactors = &pattern->cofactors;
    if (pattern->warps) {
        space->warped = pattern_affine(pattern);
        space->of_warped = affine_cofactors(&space->warped);
        space->inward = &space->warped;
        space->cofactors = &space->of_warped;
    }
}

/* A height in the pattern, of a normal that has one around it: no_bump_scale of
 * a map counts for all that is in it (measured). */
static inline double height_within(const struct normal *perturbation,
                                   double height, double around)
{
    height = fabs(height) <= DBL_MAX ? height : 1;
    return around != 0                        ? height * around
           : normal_is_unscaled(perturbation) ? height
                                              : 0;
}

/* Whether a bent normal stays as long as it has become, for the map with
 * no_bump_scale around it: one that a map has made is unit even there
 * (measured). */
static inline bool normal_keeps_length(const struct normal *perturbation,
                                       double around)
{
    return around != 0 && !perturbation->map;
}

/* `around` is in the space of what the pattern is a part of. */
static vec3 normal_bent(const struct normal *perturbation,
                        const struct bend *around)
{
    const struct pattern *pattern = &perturbation->pattern;
    if (normal_is_level(perturbation))
        return normal_raised(around->normal, around->height);
    struct bend at = { .point = pattern_locate(pattern, around->point),
                       .surface = around->surface };
    struct normal_space space;
    normal_space_of(&space, pattern);
    double height;
    at.normal = normal_into_pattern(space.cofactors, around->normal, &height);
    at.height = height_within(perturbation, height, around->height);
    vec3 local = normal_tilted(perturbation, &at);
    if (normal_keeps_length(perturbation, around->height))
        return affine_normal(space.inward, local);
    vec3 result = vec3_normalise(affine_normal(space.inward, local));
    double length = vec3_dot(result, result);
    return length > 0.5 && length < 2 ? result : around->normal;
}

/* How high bumps are for what is around the pattern, which is scaled as well.
 */
static inline double height_around(const struct normal *perturbation,
                                   double length)
{
    bool sensible = length > 0 && length <= DBL_MAX;
    return normal_is_unscaled(perturbation) && sensible ? length : 0;
}

vec3 normal_perturbed(const struct normal *perturbation, vec3 point,
                      vec3 normal, double length,
                      const struct uv_source *surface)
{
    const struct bend around = { point, normal, surface,
                                 height_around(perturbation, length) };
    return normal_bent(perturbation, &around);
}

CLONES static void normals_into_pattern(const struct cofactors *restrict map,
                                        const struct spots *restrict normals,
                                        struct spots *restrict inner,
                                        double *restrict heights)
{
    for (int i = 0; i < normals->count; i++) {
        double height;
        vec3 local = normal_into_pattern(map, spots_at(normals, i), &height);
        heights[i] = height;
        spots_put(inner, i, local);
    }
}

/* The bent ones, where they are in the pattern, brought back; where nothing
 * sensible comes of it those that there were. */
CLONES static void normals_out_of_pattern(const affine *restrict inward,
                                          const struct spots *restrict local,
                                          const struct spots *restrict normals,
                                          struct spots *restrict perturbed)
{
    for (int i = 0; i < normals->count; i++) {
        vec3 normal = spots_at(normals, i);
        vec3 result = vec3_normalise(affine_normal(inward, spots_at(local, i)));
        double length = vec3_dot(result, result);
        bool good = (length > 0.5) & (length < 2);
        spots_put(perturbed, i,
                  vec3_make(good ? result.x : normal.x,
                            good ? result.y : normal.y,
                            good ? result.z : normal.z));
    }
}

/* Several of them, on no surface. */
struct bends {
    struct spots points, normals;
    double height[SPOTS_MAX];
};

static void normals_bent(const struct normal *perturbation,
                         const struct bends *around, struct spots *bent);

static void entry_normals(const struct normal_entry *entry,
                          const struct bends *at, struct spots *bent)
{
    bent->count = at->normals.count;
    if (entry->normal)
        normals_bent(entry->normal, at, bent);
    else
        for (int i = 0; i < bent->count; i++)
            spots_put(bent, i,
                      normal_raised(spots_at(&at->normals, i), at->height[i]));
}

/* average_normal of them. */
static void average_normals(const struct normal_map *map,
                            const struct bends *at, struct spots *bent)
{
    struct spots each;
    bent->count = at->points.count;
    for (int k = 0; k < bent->count; k++)
        spots_put(bent, k, vec3_make(0, 0, 0));
    for (size_t i = 0; i < map->count; i++) {
        entry_normals(&map->entries[i], at, &each);
        for (int k = 0; k < bent->count; k++)
            spots_put(bent, k,
                      vec3_along(spots_at(bent, k), spots_at(&each, k),
                                 map->entries[i].value));
    }
}

/* Those of `lanes`, which are all between an entry and the one before it, or
 * all at it. */
static void places_bend(const struct normal_entry *entry, bool mixed,
                        unsigned lanes, const struct map_place *places,
                        const struct bends *at, struct spots *bent)
{
    struct bends some; /* no more of it than is needed */
    struct spots high, low;
    some.points.count = some.normals.count = 0;
    for (unsigned each = lanes; each; each &= each - 1) {
        int i = __builtin_ctz(each);
        some.height[some.points.count] = at->height[i];
        spots_add(&some.points, spots_at(&at->points, i));
        spots_add(&some.normals, spots_at(&at->normals, i));
    }
    entry_normals(entry, &some, &high);
    if (mixed)
        entry_normals(entry - 1, &some, &low);
    for (int k = 0; lanes; lanes &= lanes - 1, k++) {
        int i = __builtin_ctz(lanes);
        vec3 to = spots_at(&high, k);
        spots_put(bent, i,
                  mixed ? vec3_mix(spots_at(&low, k), to, places[i].share)
                        : to);
    }
}

/* map_normal of them. */
static void map_normals(const struct normal *perturbation,
                        const struct bends *at, struct spots *bent)
{
    const struct pattern_kind *kind = perturbation->pattern.kind;
    const struct normal_map *map = perturbation->map;
    struct map_place places[SPOTS_MAX];
    double values[SPOTS_MAX];
    unsigned lanes = (1u << at->points.count) - 1;
    if (kind->average) {
        average_normals(map, at, bent);
        return;
    }
    pattern_values_at(&perturbation->pattern, &at->points, values);
    for (int i = 0; i < at->points.count; i++) {
        places[i] = map_place_of(&map->entries[0].value, sizeof map->entries[0],
                                 map->count, values[i]);
        if (kind->blocks)
            places[i].share = 1;
    }
    bent->count = at->points.count;
    while (lanes) {
        const struct map_place first = places[__builtin_ctz(lanes)];
        unsigned same = 0;
        for (unsigned each = lanes; each; each &= each - 1) {
            const struct map_place *place = &places[__builtin_ctz(each)];
            bool is = place->entry == first.entry &&
                      (place->share < 1) == (first.share < 1);
            same |= is ? each & -each : 0;
        }
        places_bend(&map->entries[first.entry], first.share < 1, same, places,
                    at, bent);
        lanes &= ~same;
    }
}

/* What bends them instead of a map. */
static void tilt_normals(const struct normal *perturbation,
                         const struct bends *at, struct spots *bent)
{
    vec3 tilts[SPOTS_MAX];
    normal_tilts_at(perturbation, &at->points, &at->normals, tilts);
    bent->count = at->points.count;
    for (int i = 0; i < bent->count; i++)
        spots_put(
            bent, i,
            vec3_along(normal_raised(spots_at(&at->normals, i), at->height[i]),
                       tilts[i], normal_amount(perturbation)));
}

/* normal_bent of several. */
static void normals_bent(const struct normal *perturbation,
                         const struct bends *around, struct spots *bent)
{
    struct normal_space space;
    struct bends at;
    struct spots local;
    bent->count = at.normals.count = around->points.count;
    if (normal_is_level(perturbation)) {
        for (int i = 0; i < bent->count; i++)
            spots_put(bent, i,
                      normal_raised(spots_at(&around->normals, i),
                                    around->height[i]));
        return;
    }
    normal_space_of(&space, &perturbation->pattern);
    pattern_locate_all(&perturbation->pattern, &around->points, &at.points);
    normals_into_pattern(space.cofactors, &around->normals, &at.normals,
                         at.height);
    for (int i = 0; i < bent->count; i++)
        at.height[i] =
            height_within(perturbation, at.height[i], around->height[i]);
    if (perturbation->map)
        map_normals(perturbation, &at, &local);
    else
        tilt_normals(perturbation, &at, &local);
    normals_out_of_pattern(space.inward, &local, &around->normals, bent);
    for (int i = 0; i < bent->count; i++)
        if (normal_keeps_length(perturbation, around->height[i]))
            spots_put(bent, i,
                      affine_normal(space.inward, spots_at(&local, i)));
}

void normals_perturbed(const struct normal *perturbation,
                       const struct spots *points, const struct spots *normals,
                       const double *lengths, struct spots *perturbed)
{
    struct bends around = { *points, *normals, { 0 } };
    for (int i = 0; i < points->count; i++)
        around.height[i] =
            lengths ? height_around(perturbation, lengths[i]) : 0;
    normals_bent(perturbation, &around, perturbed);
}

const struct normal *normal_moved(struct arena *arena,
                                  const struct normal *normal,
                                  const affine *transform)
{
    struct normal *moved = ARENA_NEW(arena, struct normal);
    *moved = *normal;
    pattern_transform(&moved->pattern, transform);
    return moved;
}

/* Corners of convex polyhedra by trying all triples of planes: see
 * halfspace.h. Few planes, once for each object. */
#include "world/halfspace.h"

enum { ALL_MAX = HALFSPACES_MAX + 6 };

struct planes {
    struct halfspace at[ALL_MAX];
    int count;
};

static void add_side(struct planes *planes, vec3 normal, double distance)
{
    if (isfinite(distance))
        planes->at[planes->count++] = (struct halfspace){ normal, distance };
}

static void add_region(struct planes *planes, struct box3 region)
{
    add_side(planes, vec3_make(1, 0, 0), region.high.x);
    add_side(planes, vec3_make(-1, 0, 0), -region.low.x);
    add_side(planes, vec3_make(0, 1, 0), region.high.y);
    add_side(planes, vec3_make(0, -1, 0), -region.low.y);
    add_side(planes, vec3_make(0, 0, 1), region.high.z);
    add_side(planes, vec3_make(0, 0, -1), -region.low.z);
}

/* Whether one may walk this way for ever. */
static bool is_open(const struct planes *planes, vec3 direction)
{
    for (int i = 0; i < planes->count; i++)
        if (vec3_dot(planes->at[i].normal, direction) > 1e-9)
            return false;
    return true;
}

/* The ways out of an unbounded polyhedron are spanned by lines in which two of
 * its planes meet. */
static bool is_bounded(const struct planes *planes)
{
    bool meet = false;
    for (int i = 0; i < planes->count; i++) {
        for (int j = 0; j < i; j++) {
            vec3 line = vec3_cross(planes->at[i].normal, planes->at[j].normal);
            if (vec3_length(line) < 1e-6)
                continue;
            meet = true;
            line = vec3_normalise(line);
            if (is_open(planes, line) || is_open(planes, vec3_negate(line)))
                return false;
        }
    }
    return meet;
}

/* Where three planes meet; false if they don't in one point. */
static bool find_corner(const struct halfspace *a, const struct halfspace *b,
                        const struct halfspace *c, vec3 *out)
{
    vec3 bc = vec3_cross(b->normal, c->normal);
    vec3 ca = vec3_cross(c->normal, a->normal);
    vec3 ab = vec3_cross(a->normal, b->normal);
    double volume = vec3_dot(a->normal, bc);
    if (fabs(volume) < 1e-9)
        return false;
    vec3 sum = vec3_scale(bc, a->distance);
    sum = vec3_along(sum, ca, b->distance);
    sum = vec3_along(sum, ab, c->distance);
    *out = vec3_scale(sum, 1 / volume);
    return vec3_finite(*out);
}

static bool holds(const struct planes *planes, vec3 point)
{
    double slack = 1e-7 * (1 + vec3_length(point));
    for (int i = 0; i < planes->count; i++)
        if (vec3_dot(planes->at[i].normal, point) >
            planes->at[i].distance + slack)
            return false;
    return true;
}

struct box3 halfspaces_box(const struct halfspace *halfspaces, int count,
                           struct box3 region)
{
    struct planes planes = { .count = 0 };
    struct box3 box = box3_empty();
    for (int i = 0; i < count && i < HALFSPACES_MAX; i++)
        planes.at[planes.count++] = halfspaces[i];
    add_region(&planes, region);
    if (!is_bounded(&planes))
        return region;
    for (int i = 0; i < planes.count; i++)
        for (int j = 0; j < i; j++)
            for (int k = 0; k < j; k++) {
                vec3 corner;
                if (find_corner(&planes.at[i], &planes.at[j], &planes.at[k],
                                &corner) &&
                    holds(&planes, corner))
                    box = box3_add(box, corner);
            }
    if (box3_is_empty(box))
        return region; /* nothing, or too flat to be sure */
    double slack = 1e-6 * (1 + vec3_length(box.low) + vec3_length(box.high));
    return box3_intersection(box3_grown(box, slack), region);
}

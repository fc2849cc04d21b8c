/* Cells through the tree of a solid: see overlap.h. The rule of CSG (solid.h)
 * with "may be" for "is": a surface counts in the cell if all siblings may be
 * inside (or outside) somewhere in it. */
#include "world/overlap.h"

#include "world/mesh_tree.h"
#include "scene/mesh.h"
#include "scene/primitive.h"

struct overlap_query {
    const uint8_t *marks;
    bool last;
};

/* Whether no point of the box around the cell is in the other box. */
static inline bool apart(const struct cell *cell, const struct box3 *box)
{
    vec3 c = cell->centre, h = cell->half;
    return box->low.x > c.x + h.x || box->high.x < c.x - h.x ||
           box->low.y > c.y + h.y || box->high.y < c.y - h.y ||
           box->low.z > c.z + h.z || box->high.z < c.z - h.z ||
           box3_is_empty(*box);
}

/* Without a test of its own a shape is asked along the sides, the diagonals
 * and the middle lines of the cell. */
static unsigned searched(const struct leaf *leaf, const struct cell *cell)
{
    const struct primitive *primitive = leaf->object->primitive;
    vec3 way[7];
    for (int i = 0; i < 4; i++)
        way[i] = vec3_sub(cell_corner(cell, 7 - i), cell->centre);
    for (int i = 0; i < 3; i++)
        way[4 + i] = cell->side[i];
    for (int i = 0; i < 7; i++) {
        struct ray ray = { cell->centre, way[i] };
        struct hits hits = { .count = 0 };
        primitive->intersect(leaf->shape, &ray, &hits);
        for (int k = 0; k < hits.count; k++)
            if (fabs(hits.at[k].t) <= 1)
                return CELL_SURFACE | CELL_BORDER;
    }
    return 0;
}

/* Without a test of its own a shape may be anywhere in large cells. */
static unsigned shape_meets(const struct leaf *leaf, const struct cell *cell,
                            bool last)
{
    const struct primitive *primitive = leaf->object->primitive;
    if (primitive->meets)
        return primitive->meets(leaf->shape, cell);
    struct box3 box = primitive->bounds(leaf->shape);
    if (apart(cell, &box))
        return 0;
    return last ? searched(leaf, cell) : CELL_SURFACE | CELL_BORDER;
}

static const struct overlap nothing = { 0, false, true };

/* What has no border in the cell is all inside or all outside. */
static struct overlap leaf_overlap(const struct overlap_query *query,
                                   const struct solid *solid,
                                   const struct cell *cell)
{
    const struct leaf *leaf = solid->leaf;
    const struct object *object = leaf->object;
    struct cell moved = *cell;
    if (solid->moved)
        moved = cell_moved(cell, solid->to_shape);
    bool shape = solid->kind == OBJECT_SHAPE;
    unsigned meets = shape ? shape_meets(leaf, &moved, query->last)
                     : mesh_tree_meets(solid->more->tree, &moved)
                         ? CELL_SURFACE | CELL_BORDER
                         : 0;
    struct overlap found = nothing;
    if (meets & CELL_SURFACE)
        found.marks = query->marks[leaf->number];
    if (shape ? !object->primitive->solid : !object->mesh->solid)
        return found;
    bool inside = shape ? object->primitive->inside(leaf->shape, moved.centre)
                        : mesh_tree_inside(solid->more->tree, moved.centre);
    found.inside = (meets & CELL_BORDER) || inside != leaf->look->inverse;
    found.outside = (meets & CELL_BORDER) || inside == leaf->look->inverse;
    return found;
}

static struct overlap part_overlap(const struct overlap_query *query,
                                   const struct solid *solid,
                                   const struct cell *cell);

/* Surfaces of children where all their siblings may agree: two children that
 * don't leave none but their own surfaces, three leave nothing. */
static struct overlap meet_overlap(const struct overlap_query *query,
                                   const struct solid *solid,
                                   const struct cell *cell, bool intersection)
{
    uint8_t marks = 0, lone = 0;
    size_t against = 0;
    struct overlap all = { 0, intersection, !intersection };
    for (size_t i = 0; i < solid->child_count && against < 2; i++) {
        struct overlap one = part_overlap(query, solid->children[i], cell);
        bool agrees = intersection ? one.inside : one.outside;
        marks |= one.marks;
        if (!agrees) {
            against++;
            lone = one.marks;
        }
        if (intersection) {
            all.inside = all.inside && one.inside;
            all.outside = all.outside || one.outside;
        } else {
            all.inside = all.inside || one.inside;
            all.outside = all.outside && one.outside;
        }
    }
    all.marks = against == 0 ? marks : against == 1 ? lone : 0;
    return all;
}

static struct overlap union_overlap(const struct overlap_query *query,
                                    const struct solid *solid,
                                    const struct cell *cell)
{
    struct overlap all = nothing;
    for (size_t i = 0; i < solid->child_count; i++) {
        struct overlap one = part_overlap(query, solid->children[i], cell);
        all.marks |= one.marks;
        all.inside = all.inside || one.inside;
        all.outside = all.outside && one.outside;
    }
    return all;
}

static struct overlap content_overlap(const struct overlap_query *query,
                                      const struct solid *solid,
                                      const struct cell *cell)
{
    switch (solid->kind) {
    case OBJECT_SHAPE:
    case OBJECT_MESH:
        return leaf_overlap(query, solid, cell);
    case OBJECT_INTERSECTION:
    case OBJECT_MERGE:
        return meet_overlap(query, solid, cell,
                            solid->kind == OBJECT_INTERSECTION);
    case OBJECT_UNION:
    case OBJECT_LIGHT:
        break;
    }
    return union_overlap(query, solid, cell);
}

/* The boxes of the node (solid.h) settle most cells. */
static struct overlap part_overlap(const struct overlap_query *query,
                                   const struct solid *solid,
                                   const struct cell *cell)
{
    bool no_surface = apart(cell, &solid->surface);
    bool no_inside = apart(cell, solid->region);
    if (no_surface && no_inside)
        return nothing;
    if (no_surface && apart(cell, solid->holes))
        return (struct overlap){ 0, true, false };
    struct overlap found;
    if (solid->more->frame) {
        struct cell inner = cell_moved(cell, solid->more->frame->inward);
        found = content_overlap(query, solid, &inner);
    } else {
        found = content_overlap(query, solid, cell);
    }
    for (size_t i = 0; i < solid->more->clip_count; i++) {
        struct overlap clip = part_overlap(query, solid->more->clips[i], cell);
        if (!clip.inside)
            return nothing;
        found.outside = found.outside || clip.outside;
    }
    if (no_surface)
        found.marks = 0;
    if (no_inside)
        return (struct overlap){ found.marks, false, true };
    return found;
}

struct overlap solid_overlap(const struct solid *solid, vec3 centre, vec3 half,
                             bool last, const uint8_t *marks)
{
    struct overlap_query query = { marks, last };
    struct cell cell = cell_from_box(centre, half);
    return part_overlap(&query, solid, &cell);
}

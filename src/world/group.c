/* Big unions, merges and lists of subtracted shapes as balanced trees: all
 * three are associative, so (a b c d) may become ((a b) (c d)) as long as the
 * inner nodes are of the outer one's kind. */
#include "world/solid.h"

#include <stdlib.h>

enum { GROUP_SIZE = 4, GROUP_WORTH = 8 };

static vec3 child_centre(const struct solid *child)
{
    return vec3_scale(vec3_add(child->surface.low, child->surface.high), 0.5);
}

static int compare_x(const void *a, const void *b)
{
    double x = child_centre(*(struct solid *const *)a).x;
    double y = child_centre(*(struct solid *const *)b).x;
    return (x > y) - (x < y);
}

static int compare_y(const void *a, const void *b)
{
    double x = child_centre(*(struct solid *const *)a).y;
    double y = child_centre(*(struct solid *const *)b).y;
    return (x > y) - (x < y);
}

static int compare_z(const void *a, const void *b)
{
    double x = child_centre(*(struct solid *const *)a).z;
    double y = child_centre(*(struct solid *const *)b).z;
    return (x > y) - (x < y);
}

static void sort_along_longest(struct solid **children, size_t count)
{
    struct box3 box = box3_empty();
    for (size_t i = 0; i < count; i++)
        box = box3_add(box, child_centre(children[i]));
    vec3 size = vec3_sub(box.high, box.low);
    int (*compare)(const void *, const void *) =
        size.x >= size.y && size.x >= size.z ? compare_x
        : size.y >= size.z                   ? compare_y
                                             : compare_z;
    qsort(children, count, sizeof *children, compare);
}

/* The children under nodes of the parent's kind; returns the topmost. */
static struct solid *group(struct arena *arena, const struct solid *parent,
                           struct solid **children, size_t count)
{
    struct solid *node = solid_new(arena, parent->kind);
    if (count <= GROUP_SIZE) {
        node->children = ARENA_ARRAY(arena, struct solid *, count);
        node->child_count = (unsigned)count;
        memcpy(node->children, children, count * sizeof *children);
    } else {
        sort_along_longest(children, count);
        size_t half = count / 2;
        node->children = ARENA_ARRAY(arena, struct solid *, 2);
        node->child_count = 2;
        node->children[0] = group(arena, parent, children, half);
        node->children[1] = group(arena, parent, children + half, count - half);
    }
    for (size_t i = 0; i < node->child_count; i++)
        node->children[i]->parent = node;
    solid_measure(arena, node);
    return node;
}

/* Whether the child, where it is far, changes nothing. */
static bool child_is_local(const struct solid *parent,
                           const struct solid *child)
{
    struct box3 reach =
        *(parent->kind == OBJECT_INTERSECTION ? child->holes : child->region);
    return box3_is_finite(reach) && box3_is_finite(child->surface);
}

void solid_group(struct arena *arena, struct solid *solid)
{
    size_t local = 0, kept = 0;
    if (solid->child_count <= GROUP_WORTH)
        return;
    struct solid **children =
        ARENA_ARRAY(arena, struct solid *, solid->child_count);
    for (size_t i = 0; i < solid->child_count; i++) {
        struct solid *child = solid->children[i];
        if (child_is_local(solid, child))
            children[local++] = child;
        else
            solid->children[kept++] = child;
    }
    if (local > GROUP_WORTH) {
        solid->children[kept] = group(arena, solid, children, local);
        solid->children[kept++]->parent = solid;
    } else {
        memcpy(solid->children + kept, children, local * sizeof *children);
        kept += local;
    }
    solid->child_count = (unsigned)kept;
}

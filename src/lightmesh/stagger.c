/* Staggered lattices: see stagger.h. */
#include "lightmesh/stagger.h"

#include <limits.h>
#include <stdbool.h>
#include <stdlib.h>

#include "base/memory.h"

/* Skews for which the points are as far from each other as they can be. */
static const struct stagger staggers[] = {
    { 1, 0, 0, 0, NULL }, { 2, 1, 1, 1, NULL },  { 4, 2, 2, 1, NULL },
    { 8, 3, 3, 2, NULL }, { 16, 6, 4, 3, NULL },
};

enum { STAGGERS = sizeof staggers / sizeof *staggers };

int stagger_apart(double wanted)
{
    int i = 0;
    while (i + 1 < STAGGERS &&
           wanted * wanted > staggers[i].apart * staggers[i + 1].apart)
        i++;
    return staggers[i].apart;
}

static int stagger_class(const struct stagger *stagger, int x, int y)
{
    unsigned skewed = (unsigned)x + (unsigned)stagger->skew * (unsigned)y;
    return (int)(skewed & (unsigned)(stagger->apart - 1));
}

int stagger_level(const struct stagger *stagger, int x, int y)
{
    int class = stagger_class(stagger, x, y);
    return class == 0 ? 0 : stagger->depth - __builtin_ctz((unsigned)class);
}

int stagger_step(const struct stagger *stagger, int level)
{
    return level == 0 ? stagger->apart : stagger->apart >> (level - 1);
}

/* Classes of a level are those in the middle between two of the ones before. */
int stagger_first(const struct stagger *stagger, int level, int from, int y)
{
    int step = stagger_step(stagger, level);
    int class = stagger_class(stagger, from, y);
    int wanted = level == 0 ? 0 : step / 2;
    return from + ((wanted - class) & (step - 1));
}

const struct servers *stagger_servers(const struct stagger *stagger, int x,
                                      int y)
{
    return &stagger->servers[stagger_class(stagger, x, y)];
}

/* Above 0 if b is to the left of a. */
static int turn(struct server a, struct server b)
{
    return a.across * b.down - a.down * b.across;
}

static int square(struct server a)
{
    return a.across * a.across + a.down * a.down;
}

/* How large the triangle is, if the pixel is in it; INT_MAX: it is not. */
static int triangle_size(const struct server corner[3])
{
    int ab = turn(corner[0], corner[1]), bc = turn(corner[1], corner[2]);
    int ca = turn(corner[2], corner[0]);
    if (ab < 0 || bc < 0 || ca < 0 || ab + bc + ca == 0)
        return INT_MAX;
    return square(corner[0]) + square(corner[1]) + square(corner[2]);
}

/* The corners of the smallest triangle around the pixel. False: none. */
static bool smallest_triangle(const struct servers *all,
                              struct server corner[3])
{
    int best = INT_MAX, count = all->count;
    for (int i = 0; i < count * count * count; i++) {
        const struct server tried[3] = { all->at[i % count],
                                         all->at[i / count % count],
                                         all->at[i / count / count] };
        int size = triangle_size(tried);
        for (int k = 0; size < best && k < 3; k++)
            corner[k] = tried[k];
        best = size < best ? size : best;
    }
    return best < INT_MAX;
}

static void servers_fill(const struct stagger *stagger, int class,
                         struct servers *own)
{
    struct servers all = { .count = 0 };
    int wide = stagger->depth > 0 ? stagger->reach + 1 : 0;
    for (int down = -wide; down <= wide; down++)
        for (int across = -wide; across <= wide; across++)
            if (stagger_class(stagger, class + across, down) == 0)
                all.at[all.count++] = (struct server){ across, down };
    own->count = smallest_triangle(&all, own->at) ? 3 : 0;
    for (int i = 0; i < all.count; i++) {
        const struct server *at = &all.at[i];
        bool near = abs(at->across) <= stagger->reach &&
                    abs(at->down) <= stagger->reach;
        for (int k = 0; k < 3 && k < own->count; k++)
            near = near && (own->at[k].across != at->across ||
                            own->at[k].down != at->down);
        if (near)
            own->at[own->count++] = *at;
    }
}

struct stagger *stagger_new(int apart)
{
    struct stagger *stagger = memory_new(sizeof *stagger);
    int i = 0;
    while (i + 1 < STAGGERS && staggers[i].apart < apart)
        i++;
    *stagger = staggers[i];
    stagger->servers =
        memory_new((size_t)stagger->apart * sizeof *stagger->servers);
    for (int class = 0; class < stagger->apart; class ++)
        servers_fill(stagger, class, &stagger->servers[class]);
    return stagger;
}

void stagger_free(struct stagger *stagger)
{
    if (!stagger)
        return;
    memory_free(stagger->servers);
    memory_free(stagger);
}

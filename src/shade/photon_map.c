/* The k-d tree of photons: see photon_map.h. */
#include "shade/photon_map.h"

#include "base/clones.h"
#include "base/memory.h"
#include "base/order.h"
#include "base/parallel.h"

#include <stdlib.h>
#include <string.h>

enum {
    LEAF_PHOTONS = 8,  /* not sorted any more; looked at together */
    DEPTH_MAX = 40,    /* of halvings, more than PHOTONS_MOST allows */
    PARTS_LEVEL = 6,   /* 2^6 parts of the tree are sorted side by side */
    RADII_TRIED = 400, /* to know how dense photons are */
    NEAR_FEW = 256,    /* that a stack has room for */
};

static const double pi = 3.14159265358979323846;

/* Of the radii at which places find as many photons as they look for, this
 * share is enough: sparser ones find fewer. */
static const double radius_quantile = 0.8;

/* Photons farther from the tangent plane than this share of their distance
 * are of another surface. */
static const float flatness = 0.5F;

/* What rounding may take from the way to a place. */
static const float reach_spare = 1.0001F;

struct photon_map {
    struct photon *photons;
    float *at[3]; /* their places once more, and room for a leaf behind them */
    size_t count;
    unsigned least, most;
    float reach; /* square of the largest radius */
    struct photon_map *within;
};

void photon_pack(vec3 d, int16_t packed[2])
{
    double sum = fabs(d.x) + fabs(d.y) + fabs(d.z);
    double x = sum > 0 ? d.x / sum : 0, y = sum > 0 ? d.y / sum : 0;
    if (d.z < 0) {
        double turned = (1 - fabs(y)) * (x < 0 ? -1 : 1);
        y = (1 - fabs(x)) * (y < 0 ? -1 : 1);
        x = turned;
    }
    packed[0] = (int16_t)lrint(x * 32767);
    packed[1] = (int16_t)lrint(y * 32767);
}

/* Of some length. */
static inline vec3 photon_direction(const int16_t packed[2])
{
    double x = packed[0], y = packed[1], all = 32767;
    double z = all - fabs(x) - fabs(y);
    if (z < 0) {
        double turned = (all - fabs(y)) * (x < 0 ? -1 : 1);
        y = (all - fabs(x)) * (y < 0 ? -1 : 1);
        x = turned;
    }
    return vec3_make(x, y, z);
}

vec3 photon_unpack(const int16_t packed[2])
{
    return vec3_normalise(photon_direction(packed));
}

/* ---- building ---- */

struct photon_range {
    size_t from, to; /* one past the last */
};

static unsigned range_axis(const struct photon *photons,
                           const struct photon_range *range)
{
    float low[3], high[3];
    unsigned axis = 0;
    for (int k = 0; k < 3; k++)
        low[k] = high[k] = photons[range->from].at[k];
    for (size_t i = range->from + 1; i < range->to; i++)
        for (int k = 0; k < 3; k++) {
            float x = photons[i].at[k];
            low[k] = x < low[k] ? x : low[k];
            high[k] = x > high[k] ? x : high[k];
        }
    for (unsigned k = 1; k < 3; k++)
        if (high[k] - low[k] > high[axis] - low[axis])
            axis = k;
    return axis;
}

static void photon_swap(struct photon *a, struct photon *b)
{
    struct photon kept = *a;
    *a = *b;
    *b = kept;
}

/* The middle one where sorting would put it, none larger before it and none
 * smaller behind (Hoare 1961). */
static void range_select(struct photon *photons, struct photon_range range,
                         size_t middle, unsigned axis)
{
    while (range.to - range.from > 1) {
        float pivot = photons[(range.from + range.to - 1) / 2].at[axis];
        size_t i = range.from, j = range.to - 1;
        for (;;) {
            while (photons[i].at[axis] < pivot)
                i++;
            while (photons[j].at[axis] > pivot)
                j--;
            if (i >= j)
                break;
            photon_swap(&photons[i++], &photons[j--]);
        }
        /* Up to j none is larger than the pivot; from j + 1 none smaller. */
        if (middle <= j)
            range.to = j + 1;
        else
            range.from = j + 1;
    }
}

static size_t range_split(struct photon *photons,
                          const struct photon_range *range)
{
    size_t middle = (range->from + range->to) / 2;
    unsigned axis = range_axis(photons, range);
    range_select(photons, *range, middle, axis);
    photons[middle].axis = axis & 3;
    return middle;
}

static void range_build(struct photon *photons, struct photon_range range)
{
    while (range.to - range.from > LEAF_PHOTONS) {
        size_t middle = range_split(photons, &range);
        range_build(photons, (struct photon_range){ range.from, middle });
        range.from = middle + 1;
    }
}

struct building {
    struct photon *photons;
    struct photon_range parts[1 << PARTS_LEVEL];
    size_t count;
};

static void build_part(void *context, size_t item, unsigned thread)
{
    struct building *building = context;
    (void)thread;
    range_build(building->photons, building->parts[item]);
}

/* The upper levels one after the other, then what is below them. */
static void build_top(struct building *building, struct photon_range range,
                      int level)
{
    if (level == 0 || range.to - range.from <= LEAF_PHOTONS) {
        building->parts[building->count++] = range;
        return;
    }
    size_t middle = range_split(building->photons, &range);
    build_top(building, (struct photon_range){ range.from, middle }, level - 1);
    build_top(building, (struct photon_range){ middle + 1, range.to },
              level - 1);
}

/* ---- looking up ---- */

/* The photons found so far, in the order of the walk through the tree: room for
 * twice as many as are looked for. */
struct search {
    const struct photon_map *map;
    float at[3], normal[3];
    bool any; /* whatever side it came to */
    float reach;
    float *squares; /* of the distances; and as many again, to be sorted */
    uint32_t *found;
    unsigned count, most;
};

/* The number that sorting would put at `place` (Hoare 1961). */
static float square_select(float *squares, unsigned count, unsigned place)
{
    unsigned from = 0, to = count;
    while (to - from > 1) {
        float pivot = squares[from + (to - from - 1) / 2];
        unsigned i = from, j = to - 1;
        for (;;) {
            while (squares[i] < pivot)
                i++;
            while (squares[j] > pivot)
                j--;
            if (i >= j)
                break;
            float kept = squares[i];
            squares[i++] = squares[j];
            squares[j--] = kept;
        }
        if (place <= j)
            to = j + 1;
        else
            from = j + 1;
    }
    return squares[from];
}

/* The same of the search's: of photons that lie evenly most are nearer than the
 * one that is looked for, and need no sorting. */
static float search_select(const struct search *search, unsigned place)
{
    float *sorted = search->squares + 2 * search->most;
    float count = (float)search->count;
    float guess = search->reach * ((float)place - 2 * sqrtf(count)) / count;
    unsigned beyond = 0;
    for (unsigned i = 0; i < search->count; i++) {
        sorted[beyond] = search->squares[i];
        beyond += search->squares[i] >= guess;
    }
    unsigned nearer = search->count - beyond;
    if (nearer <= place)
        return square_select(sorted, beyond, place - nearer);
    memcpy(sorted, search->squares, search->count * sizeof *sorted);
    return square_select(sorted, search->count, place);
}

/* Forgets all but the nearest; of those there are enough. The others stay in
 * their order, so that sums of them do not depend on where the search began. */
static void search_settle(struct search *search)
{
    unsigned kept = 0, as_far = search->most;
    search->reach = search_select(search, search->most - 1);
    for (unsigned i = 0; i < search->count; i++)
        as_far -= search->squares[i] < search->reach;
    for (unsigned i = 0; i < search->count; i++) {
        float square = search->squares[i];
        bool last = square == search->reach && as_far > 0;
        search->squares[kept] = square;
        search->found[kept] = search->found[i];
        kept += square < search->reach || last;
        as_far -= last;
    }
    search->count = kept;
}

static inline void search_add(struct search *search, size_t number,
                              float square)
{
    search->squares[search->count] = square;
    search->found[search->count++] = (uint32_t)number;
    if (search->count == 2 * search->most)
        search_settle(search);
}

/* Whether it came to the side that the normal shows, and lies on it. */
static bool search_takes(const struct search *search,
                         const struct photon *photon, float square)
{
    const float *n = search->normal;
    float height = 0;
    for (int k = 0; k < 3; k++)
        height += (photon->at[k] - search->at[k]) * n[k];
    if (height * height > flatness * flatness * square)
        return false;
    vec3 from = photon_direction(photon->from);
    return from.x * (double)n[0] + from.y * (double)n[1] +
               from.z * (double)n[2] >
           0;
}

static inline void search_try(struct search *search, size_t number,
                              float square)
{
    const struct photon *photon = &search->map->photons[number];
    if (square < search->reach &&
        (search->any || search_takes(search, photon, square)))
        search_add(search, number, square);
}

/* The squares of the distances of a leaf's photons, and of what follows. */
static CLONES void leaf_squares(const struct search *search, size_t from,
                                float *squares)
{
    const float *x = search->map->at[0] + from;
    const float *y = search->map->at[1] + from;
    const float *z = search->map->at[2] + from;
    const float *at = search->at;
    for (int i = 0; i < LEAF_PHOTONS; i++)
        squares[i] = (x[i] - at[0]) * (x[i] - at[0]) +
                     (y[i] - at[1]) * (y[i] - at[1]) +
                     (z[i] - at[2]) * (z[i] - at[2]);
}

static void search_leaf(struct search *search, const struct photon_range *range)
{
    float squares[LEAF_PHOTONS];
    leaf_squares(search, range->from, squares);
    for (size_t i = range->from; i < range->to; i++)
        search_try(search, i, squares[i - range->from]);
}

static void search_node(struct search *search, size_t number)
{
    const struct photon *node = &search->map->photons[number];
    float square = 0;
    for (int k = 0; k < 3; k++)
        square += (node->at[k] - search->at[k]) * (node->at[k] - search->at[k]);
    search_try(search, number, square);
}

/* Nearer halves first; the others wait, with the distance to their plane. */
static void search_tree(struct search *search)
{
    const struct photon *photons = search->map->photons;
    struct {
        struct photon_range range;
        float square;
    } waiting[DEPTH_MAX];
    int count = 0;
    struct photon_range range = { 0, search->map->count };
    for (;;) {
        while (range.to - range.from > LEAF_PHOTONS) {
            size_t middle = (range.from + range.to) / 2;
            const struct photon *node = &photons[middle];
            float side = search->at[node->axis] - node->at[node->axis];
            struct photon_range low = { range.from, middle };
            struct photon_range high = { middle + 1, range.to };
            search_node(search, middle);
            waiting[count].range = side < 0 ? high : low;
            waiting[count++].square = side * side;
            range = side < 0 ? low : high;
        }
        search_leaf(search, &range);
        do
            if (count-- == 0)
                return;
        while (waiting[count].square >= search->reach);
        range = waiting[count].range;
    }
}

static void search_run(struct search *search)
{
    search->count = 0;
    search_tree(search);
    if (search->count >= search->most)
        search_settle(search);
}

/* First no farther than there must be enough if there were around the place
 * asked for before, which mostly was near; if there are not, all the way. */
static void search_first(struct search *search, struct worker *worker)
{
    struct worker_photons *before = &worker->photons;
    float all = search->reach;
    if (before->map == search->map) {
        float way = 0;
        for (int k = 0; k < 3; k++)
            way += (before->at[k] - search->at[k]) *
                   (before->at[k] - search->at[k]);
        float far = (sqrtf(before->reach) + sqrtf(way)) * reach_spare;
        search->reach = fminf(far * far, all);
    }
    float bounded = search->reach;
    search_run(search);
    if (search->count < search->most && bounded < all) {
        search->reach = all;
        search_run(search);
    }
    bool full = search->count >= search->most;
    before->map = full ? search->map : NULL;
    before->reach = search->reach;
    memcpy(before->at, search->at, sizeof before->at);
}

static void search_start(struct search *search, const struct photon_map *map,
                         vec3 point, float *squares, uint32_t *found)
{
    search->map = map;
    search->at[0] = (float)point.x;
    search->at[1] = (float)point.y;
    search->at[2] = (float)point.z;
    search->squares = squares; /* 4 * map->most */
    search->found = found;     /* 2 * map->most */
    search->most = map->most;
    search->reach = map->reach;
}

/* Once more where photons are sparse, so far that there are `least` of them,
 * but at most twice as far: else each would be a speck of its own. */
static void search_widen(struct search *search)
{
    if (search->most > search->map->least)
        search->most = search->map->least + 1; /* the farthest weighs nothing */
    search->reach = 4 * search->map->reach;
    search_run(search);
}

/* Those that were found, `all` being the kernel's integral over its radius. */
static void search_visit(const struct search *search, double all,
                         photon_visit *visit, void *context)
{
    double reach = (double)search->reach;
    if (!(reach > 0))
        return;
    for (unsigned i = 0; i < search->count; i++) {
        const struct photon *photon = &search->map->photons[search->found[i]];
        double square = (double)search->squares[i];
        double weight = (1 - square / reach) / all;
        rgb flux = { (double)photon->flux[0], (double)photon->flux[1],
                     (double)photon->flux[2] };
        visit(context, photon, rgb_scale(flux, weight));
    }
}

void photon_map_visit_within(const struct photon_map *within,
                             struct worker *worker, vec3 point,
                             photon_visit *visit, void *context)
{
    float few[2 * NEAR_FEW], *squares = few;
    uint32_t few_found[NEAR_FEW], *found = few_found;
    size_t room = 2 * (size_t)within->most;
    struct search search;
    if (within->count == 0)
        return;
    if (room > NEAR_FEW) {
        squares = ARENA_ARRAY(worker->scratch, float, 2 * room);
        found = ARENA_ARRAY(worker->scratch, uint32_t, room);
    }
    search_start(&search, within, point, squares, found);
    search.any = true;
    search_first(&search, worker);
    if (search.count < within->least)
        search_widen(&search);
    double reach = (double)search.reach;
    search_visit(&search, 8 * pi * reach * sqrt(reach) / 15, visit, context);
}

void photon_map_visit(const struct photon_map *map, struct worker *worker,
                      vec3 point, vec3 normal, photon_visit *visit,
                      void *context)
{
    struct search search;
    size_t room = 2 * (size_t)map->most;
    if (map->count == 0)
        return;
    search_start(&search, map, point,
                 ARENA_ARRAY(worker->scratch, float, 2 * room),
                 ARENA_ARRAY(worker->scratch, uint32_t, room));
    search.any = false;
    search.normal[0] = (float)normal.x;
    search.normal[1] = (float)normal.y;
    search.normal[2] = (float)normal.z;
    search_first(&search, worker);
    if (search.count < map->least)
        search_widen(&search);
    search_visit(&search, pi * (double)search.reach / 2, visit, context);
}

/* ---- the map ---- */

/* The radius within which most places find as many as they look for. */
static double map_radius(const struct photon_map *map)
{
    double radii[RADII_TRIED];
    size_t tried = map->count < RADII_TRIED ? map->count : RADII_TRIED;
    size_t room = 2 * (size_t)map->most;
    float *squares = memory_new(2 * room * sizeof *squares);
    uint32_t *found = memory_new(room * sizeof *found);
    for (size_t i = 0; i < tried; i++) {
        const float *at = map->photons[i * map->count / tried].at;
        struct search search;
        float farthest = 0;
        search_start(&search, map,
                     vec3_make((double)at[0], (double)at[1], (double)at[2]),
                     squares, found);
        search.any = true;
        search_run(&search);
        for (unsigned k = 0; k < search.count; k++)
            farthest = squares[k] > farthest ? squares[k] : farthest;
        radii[i] = sqrt((double)farthest);
    }
    memory_free(squares);
    memory_free(found);
    qsort(radii, tried, sizeof *radii, order_double);
    return tried ? radii[(size_t)(radius_quantile * (double)(tried - 1))] : 0;
}

static void map_places(struct photon_map *map)
{
    for (int k = 0; k < 3; k++) {
        map->at[k] = memory_new((map->count + LEAF_PHOTONS) * sizeof(float));
        for (size_t i = 0; i < map->count; i++)
            map->at[k][i] = map->photons[i].at[k];
    }
}

struct photon_map *photon_map_new(struct photon *photons, size_t count,
                                  const struct photon_gather *gather,
                                  unsigned threads)
{
    struct photon_map *map = memory_new(sizeof *map);
    struct building building = { .photons = photons };
    *map = (struct photon_map){ .photons = photons,
                                .count = count,
                                .least = gather->least,
                                .most = gather->most > 1 ? gather->most : 2,
                                .reach = HUGE_VALF };
    build_top(&building, (struct photon_range){ 0, count }, PARTS_LEVEL);
    parallel_run(threads, building.count, NULL, build_part, &building);
    map_places(map);
    double radius = gather->radius > 0 ? gather->radius : map_radius(map);
    map->reach = (float)(radius * gather->share * radius * gather->share);
    return map;
}

void photon_map_free(struct photon_map *map)
{
    if (!map)
        return;
    photon_map_free(map->within);
    memory_free(map->photons);
    for (int k = 0; k < 3; k++)
        memory_free(map->at[k]);
    memory_free(map);
}

void photon_map_add_within(struct photon_map *map, struct photon_map *within)
{
    map->within = within;
}

const struct photon_map *photon_map_within(const struct photon_map *map)
{
    return map->within;
}

const struct photon *photon_map_all(const struct photon_map *map, size_t *count)
{
    *count = map->count;
    return map->photons;
}

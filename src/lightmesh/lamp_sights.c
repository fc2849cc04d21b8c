/* All lamps and many points: see lamp_sights.h. */
#include "lightmesh/lamp_sights.h"

#include <string.h>

#include "base/memory.h"
#include "base/parallel.h"
#include "lightmesh/lanes.h"
#include "shade/shadow.h"

/* Points are looked at by words of so many. */
enum { WORD = 64 };

/* A lamp has some distance from all points. */
#define least_length 1e-20f

struct sights {
    const struct lamp_sights_options *options;
    struct facet_light *light;
    size_t words;
    uint64_t *within[CASTER_SPACES]; /* a bit for each point */
    uint64_t *lit;                   /* by lamp: the same, to be found */
    const uint64_t *seen;            /* by lamp: the same, found */
    uint64_t *doubt;                 /* by thread: the same */
    struct irregular **looking;      /* by thread */
};

bool lamp_sights_take(const struct lamps *lamps, const struct lamp *lamp,
                      const struct casters *casters, double detail)
{
    return lamp->light->kind != LIGHT_CYLINDER && !lamp_is_parallel(lamp) &&
           !lamps_soft(lamps, lamp) && !lamp->light->media_attenuation &&
           irregular_margin(casters, lamp->light->location) <= detail;
}

static vec3 point_vector(float *const from[3], size_t number)
{
    return vec3_make((double)from[0][number], (double)from[1][number],
                     (double)from[2][number]);
}

vec3 lamp_sights_place(const struct casters *casters,
                       const struct irregular_points *points, size_t number)
{
    return vec3_add(casters->centre, point_vector(points->place, number));
}

vec3 lamp_sights_normal(const struct irregular_points *points, size_t number)
{
    return point_vector(points->normal, number);
}

static vec3 sights_place(const struct sights *own, size_t number)
{
    return lamp_sights_place(own->options->casters, own->options->points,
                             number);
}

static bool space_holds(const struct caster_space *space, vec3 place)
{
    return vec3_dot(space->normal, place) <= space->distance;
}

/* Which points of a word are in each half space, a little above the surface
 * that they are on. */
static void place_word(void *context, size_t word, unsigned thread)
{
    struct sights *own = context;
    const struct casters *casters = own->options->casters;
    size_t count = own->options->points->count, end = (word + 1) * WORD;
    (void)thread;
    for (size_t i = word * WORD; i < end && i < count; i++) {
        vec3 place = sights_place(own, i);
        place = vec3_along(place, lamp_sights_normal(own->options->points, i),
                           shadow_start(place, HUGE_VAL));
        for (int k = 0; k < casters->space_count; k++)
            if (space_holds(&casters->spaces[k], place))
                own->within[k][word] |= 1ull << (i % WORD);
    }
}

static bool point_is_hidden(const struct sights *own, struct worker *worker,
                            const struct lamp *lamp, size_t number)
{
    struct lamp_target target = { .point = sights_place(own, number) };
    if (!lamp_look(lamp, lamp->light->location, target.point, &target.view))
        return false;
    rgb share = lamps_share_point(own->options->lamps, lamp, worker, &target);
    return rgb_peak(share) <= 0;
}

/* Rays decide what is in doubt. */
static void doubts_settle(const struct sights *own, struct worker *worker,
                          const struct lamp *lamp,
                          const struct irregular_sight *sight)
{
    for (size_t word = 0; word < own->words && !worker_stopped(worker); word++)
        for (uint64_t left = sight->doubt[word] & sight->lit[word]; left;
             left &= left - 1) {
            size_t i = word * WORD + (size_t)__builtin_ctzll(left);
            if (point_is_hidden(own, worker, lamp, i))
                sight->lit[word] &= ~(left & -left);
        }
}

static void hide_by_spaces(const struct sights *own, const struct lamp *lamp,
                           uint64_t *lit)
{
    const struct casters *casters = own->options->casters;
    for (int k = 0; k < casters->space_count; k++) {
        bool inside = space_holds(&casters->spaces[k], lamp->light->location);
        uint64_t flip = inside ? ~0ull : 0;
        for (size_t word = 0; word < own->words; word++)
            lit[word] &= ~(own->within[k][word] ^ flip);
    }
}

static void look_lamp(void *context, size_t number, unsigned thread)
{
    struct sights *own = context;
    const struct lamp *lamp = &own->options->lamps->items[number];
    if (!own->options->takes[number])
        return;
    struct irregular_sight sight = { own->lit + number * own->words,
                                     own->doubt + thread * own->words };
    struct irregular **looking = &own->looking[thread];
    bool shadows = !lamp->light->shadowless;
    if (!*looking)
        *looking = irregular_new(own->options->casters, own->options->points);
    irregular_look(*looking, lamp->light->location, shadows, &sight);
    if (!shadows)
        return;
    hide_by_spaces(own, lamp, sight.lit);
    doubts_settle(own, own->options->workers[thread], lamp, &sight);
}

/* Sums of facet lights, one array after the other. */
enum { SUMS = 12 };

struct word_sums {
    float sum[SUMS][WORD];
};

/* How much of a lamp's light gets to each of LANES points if nothing hides it;
 * 1 of those that shine alike everywhere. */
static void lamp_shares(const struct sights *own, const struct lamp *lamp,
                        size_t first, float share[LANES])
{
    bool alike_everywhere = lamp->light->kind == LIGHT_POINT && !lamp->fades;
    for (size_t i = 0; i < LANES; i++) {
        struct lamp_view view;
        share[i] = 1;
        if (!alike_everywhere)
            share[i] = lamp_look(lamp, lamp->light->location,
                                 sights_place(own, first + i), &view)
                           ? (float)view.attenuation
                           : 0;
    }
}

/* Adds the light of one lamp to those of LANES points whose bit is set. */
INLINED void sums_add(struct word_sums *sums, size_t at, const lanes offset[3],
                      const float tint[3], lanes share)
{
    lanes square =
        offset[0] * offset[0] + offset[1] * offset[1] + offset[2] * offset[2];
    lanes length;
    for (int i = 0; i < LANES; i++)
        length[i] = __builtin_sqrtf(square[i]) + least_length;
    lanes each = share / length;
    const lanes part[4] = { offset[0] * each, offset[1] * each,
                            offset[2] * each, share };
    for (int c = 0; c < 3; c++)
        for (int k = 0; k < 4; k++) {
            lanes *sum = (lanes *)(sums->sum[4 * c + k] + at);
            *sum += part[k] * tint[c];
        }
}

static const lanes_mask lane_bits = { 1, 2, 4, 8, 16, 32, 64, 128 };

INLINED void word_add(const struct sights *own, size_t word,
                      const struct lamp *lamp, uint64_t lit,
                      struct word_sums *sums)
{
    vec3 from = vec3_sub(lamp->light->location, own->options->casters->centre);
    const float at[3] = { (float)from.x, (float)from.y, (float)from.z };
    rgb c = lamp->light->colour;
    const float tint[3] = { (float)c.r, (float)c.g, (float)c.b };
    const struct irregular_points *points = own->options->points;
    for (size_t i = 0; i < WORD; i += LANES) {
        int32_t bits = (int32_t)(lit >> i & 255);
        float shares[LANES];
        lanes offset[3];
        if (!bits)
            continue;
        for (int k = 0; k < 3; k++)
            offset[k] = at[k] - lanes_load(points->place[k] + word * WORD + i);
        lamp_shares(own, lamp, word * WORD + i, shares);
        lanes_mask on = (bits & lane_bits) != 0;
        sums_add(sums, i, offset, tint,
                 lanes_choose(on, lanes_load(shares), (lanes){ 0 }));
    }
}

/* Sums all lamps over a word of points. */
INLINED void word_sum(struct sights *own, size_t word)
{
    const struct lamps *lamps = own->options->lamps;
    struct word_sums sums;
    memset(&sums, 0, sizeof sums);
    for (size_t i = 0; i < lamps->count; i++) {
        uint64_t lit = own->seen[i * own->words + word];
        if (lit)
            word_add(own, word, &lamps->items[i], lit, &sums);
    }
    for (size_t i = 0; i < WORD; i++) {
        struct facet_light *light = &own->light[word * WORD + i];
        for (int k = 0; k < 4; k++) {
            light->r[k] = sums.sum[k][i];
            light->g[k] = sums.sum[4 + k][i];
            light->b[k] = sums.sum[8 + k][i];
        }
    }
}

LANES_WIDE static void word_sum_wide(struct sights *own, size_t word)
{
    word_sum(own, word);
}

static void sum_word(void *context, size_t word, unsigned thread)
{
    (void)thread;
    if (lanes_are_wide())
        word_sum_wide(context, word);
    else
        word_sum(context, word);
}

/* Bits of half spaces, and room for what threads need. */
static void sights_start(struct sights *own)
{
    const struct lamp_sights_options *options = own->options;
    int spaces = options->casters->space_count;
    for (int k = 0; k < spaces; k++)
        own->within[k] = memory_new(own->words * sizeof(uint64_t));
    if (spaces > 0)
        parallel_run(options->threads, own->words, options->workers[0]->stop,
                     place_word, own);
    own->doubt = memory_new(options->threads * own->words * sizeof *own->doubt);
    own->looking = memory_new(options->threads * sizeof(void *));
}

static void sights_end(struct sights *own)
{
    for (unsigned i = 0; i < own->options->threads; i++)
        irregular_free(own->looking[i]);
    memory_free(own->looking);
    memory_free(own->doubt);
    for (int k = 0; k < own->options->casters->space_count; k++)
        memory_free(own->within[k]);
}

void lamp_sights_look(const struct lamp_sights_options *options, uint64_t *lit)
{
    struct sights own = {
        .options = options,
        .words = irregular_padded(options->points->count) / WORD,
        .lit = lit,
    };
    sights_start(&own);
    parallel_run(options->threads, options->lamps->count,
                 options->workers[0]->stop, look_lamp, &own);
    sights_end(&own);
}

void lamp_sights_sum(const struct lamp_sights_options *options,
                     const uint64_t *lit, struct facet_light *light)
{
    struct sights own = {
        .options = options,
        .words = irregular_padded(options->points->count) / WORD,
        .seen = lit,
        .light = light,
    };
    parallel_run(options->threads, own.words, options->workers[0]->stop,
                 sum_word, &own);
}

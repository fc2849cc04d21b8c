/* Antialiasing by method 1: pixels that differ from their neighbours get R x R
 * samples more. Measured on POV-Ray 3.7. */
#include <string.h>

#include "render/sampler_refine.h"

/* The first sample of a place that is another tile's, of which the picture may
 * have been made by now. */
static float *sampler_place_beyond(const struct sampler *sampler, int x, int y)
{
    return sampler->edges ? sampler_edge(sampler, x, y)
                          : sampler_place(sampler, x, y);
}

enum { CENTRES_WIDE = CENTRES_TILE + 1 };

/* Of the pixels of a row, one more to the left first, which ones are such:
 * their first samples differ from those to the left or above; they will most
 * likely be refined; it is known how they would be; they are. */
struct centre_row {
    uint64_t left, above, likely, known, done;
};

/* A tile of method 1, with one more column to the left and one more row above,
 * which are only looked at: its pixels as they are by now, and the means of
 * their centres and R x R samples as far as these are known. */
struct centre_pixels {
    struct centre_row rows[CENTRES_WIDE];
    float now[CENTRES_WIDE][CENTRES_WIDE][4];
    float refined[CENTRES_WIDE][CENTRES_WIDE][4];
};

/* A pixel's place in these. */
struct centre {
    int row, column;
};

struct centres {
    const struct sampler *sampler;
    struct worker *worker;
    struct area tile;
    struct centre_pixels *pixels;
};

enum {
    CENTRES_RAYS = 4 * BLOCK_MOST, /* so many together fill their packets */
    CENTRES_CELL = 8,              /* pixels close together, across and down */
};

static inline uint64_t row_bit(int column)
{
    return UINT64_C(1) << column;
}

/* Pixels that are refined together: a sample is the same whoever asks. */
struct centre_group {
    int count, most;
    struct {
        struct centre at;
        double sum[4];
    } of[CENTRES_RAYS];
};

/* Which of a pixel's R x R samples is its first one again: without jitter the
 * middle one of an odd number; else none (-1). */
static int sampler_again(const struct sampler *sampler)
{
    int n = sampler_depth(sampler);
    return sampler->options->jitter == 0 && n % 2 ? n * n / 2 : -1;
}

static void group_add(struct centre_group *group, const struct centres *c,
                      struct centre at)
{
    int i = group->count++, times = sampler_again(c->sampler) < 0 ? 1 : 2;
    c->pixels->rows[at.row].known |= row_bit(at.column);
    group->of[i].at = at;
    for (int k = 0; k < 4; k++)
        group->of[i].sum[k] =
            times * (double)c->pixels->now[at.row][at.column][k];
}

/* The pixel, and those close to it that will most likely be asked for after it:
 * most of their rays meet the same. Nobody who follows the rays one by one
 * wants others between them. */
static void group_gather(struct centre_group *group, const struct centres *c,
                         struct centre at)
{
    int n = sampler_depth(c->sampler), again = sampler_again(c->sampler) >= 0;
    int few = n * n > again ? CENTRES_RAYS / (n * n - again) : 1;
    int left = at.column - (at.column - 1) % CENTRES_CELL;
    int top = at.row - (at.row - 1) % CENTRES_CELL;
    uint64_t cell = row_bit(left + CENTRES_CELL) - row_bit(left);
    group->count = 0;
    group->most = c->worker->telling ? 1 : few > 1 ? few : 1;
    group_add(group, c, at);
    for (int i = top; i < top + CENTRES_CELL && i < CENTRES_WIDE; i++) {
        const struct centre_row *row = &c->pixels->rows[i];
        uint64_t likely = row->likely & ~row->known & cell;
        for (; likely && group->count < group->most; likely &= likely - 1)
            group_add(group, c, (struct centre){ i, __builtin_ctzll(likely) });
    }
}

/* Samples that are seen together, and whose they are. */
struct centre_samples {
    struct sampler_block block;
    int of[BLOCK_MOST];
};

static void samples_see(struct centre_samples *samples, const struct centres *c,
                        struct centre_group *group)
{
    struct sampler_block *block = &samples->block;
    float values[BLOCK_MOST][4];
    block_values(c->sampler, c->worker, block, values);
    for (unsigned i = 0; i < block->count; i++)
        for (int k = 0; k < 4; k++)
            group->of[samples->of[i]].sum[k] += (double)values[i][k];
    block->count = 0;
}

enum { SAMPLES_MOST = DEPTH_MOST * DEPTH_MOST };

/* Where a pixel's n x n samples are in it, across and down. */
static void spread_samples(double (*spread)[2], int n, double jitter,
                           uint64_t key)
{
    for (int i = 0, column = 0, row = 0; i < n * n; i++, column++) {
        if (column == n)
            column = 0, row++;
        double u = column + 0.5, v = row + 0.5;
        if (jitter != 0) {
            u += jitter * jitter_number(key, 2 * i);
            v += jitter * jitter_number(key, 2 * i + 1);
        }
        spread[i][0] = u / n;
        spread[i][1] = v / n;
    }
}

/* Without jitter they are the same in all of them. */
static void group_sample(struct centre_group *group, const struct centres *c)
{
    const struct sampler *sampler = c->sampler;
    int n = sampler_depth(sampler), again = sampler_again(sampler);
    double jitter = sampler->options->jitter, spread[SAMPLES_MOST][2];
    struct centre_samples samples;
    struct sampler_block *block = &samples.block;
    block->count = 0;
    if (jitter == 0)
        spread_samples(spread, n, 0, 0);
    for (int p = 0; p < group->count; p++) {
        int x = c->tile.left + group->of[p].at.column - 1;
        int y = c->tile.top + group->of[p].at.row - 1;
        unsigned long long number = worker_pixel(c->worker);
        if (jitter != 0)
            spread_samples(spread, n, jitter, jitter_key(x, y));
        for (int i = 0; i < n * n; i++) {
            if (i == again)
                continue;
            struct picture_place *place = &block->places[block->count];
            sampler_at(sampler, x + spread[i][0], y + spread[i][1], place);
            place->pixel = number;
            samples.of[block->count++] = p;
            if (block->count == BLOCK_MOST)
                samples_see(&samples, c, group);
        }
    }
    if (block->count > 0)
        samples_see(&samples, c, group);
    for (int p = 0; p < group->count; p++) {
        struct centre at = group->of[p].at;
        for (int k = 0; k < 4; k++)
            c->pixels->refined[at.row][at.column][k] =
                (float)(group->of[p].sum[k] / (n * n + 1));
    }
}

static void centres_refine(const struct centres *c, struct centre at)
{
    struct centre_row *row = &c->pixels->rows[at.row];
    uint64_t bit = row_bit(at.column);
    if (at.row == 0 || at.column == 0 || row->done & bit)
        return;
    if (!(row->known & bit)) {
        struct centre_group group;
        group_gather(&group, c, at);
        group_sample(&group, c);
    }
    memcpy(c->pixels->now[at.row][at.column],
           c->pixels->refined[at.row][at.column], 4 * sizeof(float));
    row->done |= bit;
}

/* Whether a pixel differs from a neighbour as they are by now. */
static bool centres_differ(const struct centres *c, struct centre at,
                           struct centre other, bool differed)
{
    if (!(c->pixels->rows[other.row].done & row_bit(other.column)))
        return differed;
    return sampler_differ(c->sampler, c->pixels->now[at.row][at.column],
                          c->pixels->now[other.row][other.column]);
}

/* The pixel is compared with its neighbours as they are by now, refined or
 * not; where they differ both are refined, if they aren't yet. */
static void centres_pixel(const struct centres *c, struct centre at)
{
    const struct centre_row *row = &c->pixels->rows[at.row];
    struct centre beside = { at.row, at.column - 1 };
    struct centre over = { at.row - 1, at.column };
    uint64_t bit = row_bit(at.column);
    bool left = centres_differ(c, at, beside, row->left & bit);
    bool above = centres_differ(c, at, over, row->above & bit);
    if (left)
        centres_refine(c, beside);
    if (above)
        centres_refine(c, over);
    if (left || above)
        centres_refine(c, at);
}

/* The pixels of a row that may differ from a neighbour by now. */
static uint64_t row_uncertain(const struct centre_row *row)
{
    return row->left | row->above | row->done << 1 | row[-1].done;
}

static void centres_row(const struct centres *c, int row)
{
    const int wide = c->tile.right - c->tile.left;
    uint64_t ahead = row_bit(wide + 1) - row_bit(1), look;
    while ((look = row_uncertain(&c->pixels->rows[row]) & ahead) &&
           !worker_stopped(c->worker)) {
        int column = __builtin_ctzll(look);
        centres_pixel(c, (struct centre){ row, column });
        ahead &= -row_bit(column + 1);
    }
}

/* Which of the pixels of a row, bit by bit from number i on, differ from the
 * others beside them by their first samples. */
static uint64_t row_differs(const struct centres *c, const float (*row)[4],
                            const float (*other)[4])
{
    const struct sampler *sampler = c->sampler;
    const int wide = c->tile.right - c->tile.left;
    uint64_t differ = perceived_may_differ(
        sampler->perceived, row, other,
        (struct perceived_limit){ sampler->tracer->alpha ? 1 : 0,
                                  sampler->options->threshold });
    differ &= row_bit(wide) - 1;
    for (uint64_t each = differ; each; each &= each - 1) {
        int i = __builtin_ctzll(each);
        if (!sampler_differ(sampler, row[i], other[i]))
            differ &= ~row_bit(i);
    }
    return differ;
}

/* Compares the first samples. Who differs from the next to the right or below
 * will be refined, if not before then because of it. */
static void centres_compare(const struct centres *c)
{
    const int rows = c->tile.bottom - c->tile.top;
    for (int i = 1; i <= rows; i++) {
        const float(*now)[4] = c->pixels->now[i];
        struct centre_row *row = &c->pixels->rows[i];
        row->left = row_differs(c, now + 1, now) << 1;
        row->above = row_differs(c, now + 1, c->pixels->now[i - 1] + 1) << 1;
        row->likely = row->left >> 1;
        row[-1].likely |= row->above;
    }
}

/* And who differs from one that nothing refines before: what is refined may
 * not differ any more. */
static void centres_foresee(const struct centres *c)
{
    const int rows = c->tile.bottom - c->tile.top;
    for (int i = 1; i <= rows; i++) {
        struct centre_row *row = &c->pixels->rows[i];
        uint64_t beside = (row->left | row->above) << 1;
        uint64_t over = row[-1].left | row[-1].above | row[-1].left >> 1;
        row->likely |= (row->left & ~beside) | (row->above & ~over);
    }
}

/* Takes the first samples, and foresees what will be refined. */
static void centres_look(const struct centres *c)
{
    const struct area *tile = &c->tile;
    const struct sampler *sampler = c->sampler;
    const size_t wide = (size_t)(tile->right - tile->left);
    struct centre_pixels *pixels = c->pixels;
    const size_t pixel = sizeof pixels->now[0][0];
    memset(pixels->rows, 0, sizeof pixels->rows);
    for (int x = tile->left - 1; x < tile->right; x++)
        memcpy(pixels->now[0][x - tile->left + 1],
               sampler_place_beyond(sampler, x, tile->top - 1), pixel);
    for (int y = tile->top; y < tile->bottom; y++) {
        float(*row)[4] = pixels->now[y - tile->top + 1];
        memcpy(row[0], sampler_place_beyond(sampler, tile->left - 1, y), pixel);
        memcpy(row[1], sampler_place(sampler, tile->left, y), wide * pixel);
    }
    centres_compare(c);
    centres_foresee(c);
}

void centres_tile(const struct sampler *sampler, struct worker *worker,
                  struct area tile, float *scratch)
{
    struct centres c = { sampler, worker, tile, (void *)scratch };
    centres_look(&c);
    for (int i = 1; i <= tile.bottom - tile.top; i++)
        centres_row(&c, i);
    struct area wanted = area_both(tile, sampler->wanted);
    for (int y = wanted.top; y < wanted.bottom && !worker_stopped(worker); y++)
        sampler_finish(
            sampler,
            c.pixels->now[y - tile.top + 1][wanted.left - tile.left + 1],
            wanted.left, y, wanted.right - wanted.left);
}

size_t centres_scratch(void)
{
    return sizeof(struct centre_pixels) / sizeof(float) + 1;
}

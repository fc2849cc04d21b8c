/* Distance maps: the Euclidean one line by line, as the lower envelope of
 * parabolas (Felzenszwalb and Huttenlocher, Distance Transforms of Sampled
 * Functions, Theory of Computing 8, 2012, section 2), and the chessboard one by
 * two passes in raster order (Rosenfeld and Pfaltz 1968). */
#include "skeleton/distance.h"

#include <stdbool.h>

#include "base/memory.h"
#include "base/parallel.h"

/* The parabolas (x - at)^2 + height; each is the lowest from `from` up to the
 * next one's. */
struct envelope {
    int count;
    int *at;
    int32_t *height;
    double *from;
};

static struct envelope envelope_new(int size)
{
    size_t count = (size_t)size + 2;
    return (struct envelope){ 0, memory_new(count * sizeof(int)),
                              memory_new(count * sizeof(int32_t)),
                              memory_new(count * sizeof(double)) };
}

static void envelope_free(struct envelope *envelope)
{
    memory_free(envelope->at);
    memory_free(envelope->height);
    memory_free(envelope->from);
}

/* Crossings are fractions with a denominator of at most two lines' lengths, so
 * doubles tell them from every whole number. */
static void envelope_add(struct envelope *e, int at, int32_t height)
{
    double from = -HUGE_VAL;
    while (e->count > 0) {
        int k = e->count - 1, other = e->at[k];
        double rise = (double)height - e->height[k];
        double squares = (double)at * at - (double)other * other;
        from = (rise + squares) / (2.0 * (at - other));
        if (from > e->from[k]) /* always true of the first */
            break;
        e->count--;
    }
    e->at[e->count] = at;
    e->height[e->count] = height;
    e->from[e->count++] = from;
}

/* Replaces line[0], line[stride], ... by the least of distance squared plus
 * value over all places of the line. */
static void line_squared(struct envelope *e, int32_t *line, size_t stride,
                         int size, enum outside outside)
{
    e->count = 0;
    if (outside == OUTSIDE_MATTER)
        envelope_add(e, -1, 0);
    for (int i = 0; i < size; i++)
        if (line[(size_t)i * stride] != DISTANCE_NONE)
            envelope_add(e, i, line[(size_t)i * stride]);
    if (outside == OUTSIDE_MATTER)
        envelope_add(e, size, 0);
    if (e->count == 0)
        return;
    for (int i = 0, k = 0; i < size; i++) {
        while (k + 1 < e->count && e->from[k + 1] < i)
            k++;
        int d = i - e->at[k];
        line[(size_t)i * stride] = d * d + e->height[k];
    }
}

struct squared {
    const struct voxels *voxels;
    enum outside outside;
    int32_t *out;
};

/* All lines along x, then along y, of a slice across z. */
static void squared_slice_z(void *context, size_t z, unsigned thread)
{
    const struct squared *s = context;
    const int *size = s->voxels->size;
    size_t width = (size_t)size[0], area = width * (size_t)size[1];
    int32_t *slice = s->out + z * area;
    const uint8_t *empty = s->voxels->empty + z * area;
    struct envelope e = envelope_new(size[0] > size[1] ? size[0] : size[1]);
    (void)thread;
    for (size_t i = 0; i < area; i++)
        slice[i] = empty[i] ? DISTANCE_NONE : 0;
    for (int y = 0; y < size[1]; y++)
        line_squared(&e, slice + (size_t)y * width, 1, size[0], s->outside);
    for (int x = 0; x < size[0]; x++)
        line_squared(&e, slice + x, width, size[1], s->outside);
    envelope_free(&e);
}

/* All lines along z of a slice across y. */
static void squared_slice_y(void *context, size_t y, unsigned thread)
{
    const struct squared *s = context;
    const int *size = s->voxels->size;
    size_t width = (size_t)size[0], area = width * (size_t)size[1];
    struct envelope e = envelope_new(size[2]);
    (void)thread;
    for (size_t x = 0; x < width; x++)
        line_squared(&e, s->out + y * width + x, area, size[2], s->outside);
    envelope_free(&e);
}

void distance_squared(const struct voxels *v, enum outside outside,
                      unsigned threads, int32_t *out)
{
    struct squared s = { v, outside, out };
    parallel_run(threads, (size_t)v->size[2], NULL, squared_slice_z, &s);
    parallel_run(threads, (size_t)v->size[1], NULL, squared_slice_y, &s);
}

/* A pass of the chessboard distance, forwards (step 1) or backwards (-1). The
 * 13 neighbours already seen are those of four rows and the one before in the
 * same row. */
struct raster {
    const struct voxels *voxels;
    uint16_t *out;
    int step;
    uint16_t border; /* value of what is outside of the grid */
    uint16_t *outer; /* a row of it */
    uint16_t *least; /* of the four rows, from place -1 on */
};

static const uint16_t *raster_row(const struct raster *r, int y, int z)
{
    const int *size = r->voxels->size;
    if (y < 0 || y >= size[1] || z < 0 || z >= size[2])
        return r->outer;
    return r->out + voxels_index(r->voxels, 0, y, z);
}

static uint16_t smaller(uint16_t a, uint16_t b)
{
    return a < b ? a : b;
}

static void raster_line(const struct raster *r, int y, int z)
{
    int size = r->voxels->size[0], step = r->step;
    uint16_t *row = r->out + voxels_index(r->voxels, 0, y, z);
    uint16_t *least = r->least + 1;
    const uint16_t *a = raster_row(r, y - 1, z - step);
    const uint16_t *b = raster_row(r, y, z - step);
    const uint16_t *c = raster_row(r, y + 1, z - step);
    const uint16_t *d = raster_row(r, y - step, z);
    for (int x = 0; x < size; x++)
        least[x] = smaller(smaller(a[x], b[x]), smaller(c[x], d[x]));
    for (int x = 0; x < size; x++) {
        uint16_t near = smaller(smaller(least[x - 1], least[x]), least[x + 1]);
        row[x] = smaller(row[x], (uint16_t)(near + 1));
    }
    uint16_t before = r->border;
    for (int i = 0, x = step > 0 ? 0 : size - 1; i < size; i++, x += step)
        before = row[x] = smaller(row[x], (uint16_t)(before + 1));
}

static void raster_pass(const struct raster *r)
{
    const int *size = r->voxels->size;
    for (int i = 0; i < size[2]; i++) {
        int z = r->step > 0 ? i : size[2] - 1 - i;
        for (int j = 0; j < size[1]; j++)
            raster_line(r, r->step > 0 ? j : size[1] - 1 - j, z);
    }
}

void distance_chessboard(const struct voxels *v, enum outside outside,
                         uint16_t *out)
{
    size_t count = voxels_count(v), width = (size_t)v->size[0];
    int longest = v->size[0];
    for (int axis = 1; axis < 3; axis++)
        longest = v->size[axis] > longest ? v->size[axis] : longest;
    uint16_t most = (uint16_t)longest;
    uint16_t *rows = memory_new((2 * width + 2) * sizeof *rows);
    struct raster r = { v,    out,
                        1,    outside == OUTSIDE_MATTER ? 0 : most,
                        rows, rows + width };
    for (size_t i = 0; i < width; i++)
        r.outer[i] = r.border;
    r.least[0] = r.least[width + 1] = r.border;
    for (size_t i = 0; i < count; i++)
        out[i] = v->empty[i] ? most : 0;
    raster_pass(&r);
    r.step = -1;
    raster_pass(&r);
    memory_free(rows);
}

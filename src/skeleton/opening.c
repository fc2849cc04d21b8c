/* The opening function by six sweeps: a chessboard ball is a product of
 * intervals, so the largest that covers a voxel is found one axis at a time,
 * forwards and backwards; of the balls that reach a place only the largest can
 * matter further on. A wall ends all of them, since no ball holds matter. */
#include "skeleton/opening.h"

#include <string.h>

#include "base/memory.h"
#include "base/parallel.h"

/* Balls along a line: radii fall, and ends (centre + radius) rise. */
struct balls {
    int first, end;
    int *reach;
    uint16_t *radius;
};

static void balls_add(struct balls *balls, int at, uint16_t radius)
{
    while (balls->first < balls->end && balls->reach[balls->first] <= at)
        balls->first++;
    while (balls->first < balls->end && balls->radius[balls->end - 1] <= radius)
        balls->end--;
    int reach = at + radius;
    if (balls->first < balls->end && balls->reach[balls->end - 1] >= reach)
        return;
    balls->reach[balls->end] = reach;
    balls->radius[balls->end++] = radius;
}

/* At most one ball is added for each place, so `size` of them are enough. */
static void sweep(struct balls *balls, uint16_t *line, ptrdiff_t stride,
                  int size)
{
    balls->first = balls->end = 0;
    for (int i = 0; i < size; i++, line += stride) {
        if (*line == 0) {
            balls->first = balls->end = 0;
            continue;
        }
        balls_add(balls, i, *line);
        *line = balls->radius[balls->first];
    }
}

static void sweep_both(struct balls *balls, uint16_t *line, size_t stride,
                       int size)
{
    ptrdiff_t step = (ptrdiff_t)stride;
    sweep(balls, line, step, size);
    sweep(balls, line + step * (size - 1), -step, size);
}

struct opening {
    const int *size;
    uint16_t *out;
};

static struct balls balls_new(int size)
{
    return (struct balls){ 0, 0, memory_new((size_t)size * sizeof(int)),
                           memory_new((size_t)size * sizeof(uint16_t)) };
}

static void balls_free(struct balls *balls)
{
    memory_free(balls->reach);
    memory_free(balls->radius);
}

/* Along x, then y, in a slice across z. */
static void open_slice_z(void *context, size_t z, unsigned thread)
{
    const struct opening *o = context;
    size_t width = (size_t)o->size[0], area = width * (size_t)o->size[1];
    uint16_t *slice = o->out + z * area;
    struct balls balls =
        balls_new(o->size[0] > o->size[1] ? o->size[0] : o->size[1]);
    (void)thread;
    for (int y = 0; y < o->size[1]; y++)
        sweep_both(&balls, slice + (size_t)y * width, 1, o->size[0]);
    for (int x = 0; x < o->size[0]; x++)
        sweep_both(&balls, slice + x, width, o->size[1]);
    balls_free(&balls);
}

/* Along z in a slice across y. */
static void open_slice_y(void *context, size_t y, unsigned thread)
{
    const struct opening *o = context;
    size_t width = (size_t)o->size[0], area = width * (size_t)o->size[1];
    struct balls balls = balls_new(o->size[2]);
    (void)thread;
    for (size_t x = 0; x < width; x++)
        sweep_both(&balls, o->out + y * width + x, area, o->size[2]);
    balls_free(&balls);
}

void opening_chessboard(const struct voxels *v, const uint16_t *distance,
                        unsigned threads, uint16_t *out)
{
    struct opening o = { v->size, out };
    if (out != distance)
        memcpy(out, distance, voxels_count(v) * sizeof *out);
    parallel_run(threads, (size_t)v->size[2], NULL, open_slice_z, &o);
    parallel_run(threads, (size_t)v->size[1], NULL, open_slice_y, &o);
}

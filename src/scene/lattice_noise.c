/* Solid noise: K. Perlin, "An Image Synthesizer", SIGGRAPH 1985. Each point of
 * the integer lattice has a random value and a random gradient; between them
 * the eight linear functions are blended by 3t^2 - 2t^3. The random numbers are
 * POV-Ray's (scene/noise_tables).
 *
 * Where points are in their cells is worked out for four at a time; what the
 * corners of a cell add up to for one after the other, a corner's value and
 * gradient of all fields at a time, since gathering numbers for four takes
 * longer. */
#include "scene/lattice_noise.h"

#include <string.h>

#include "base/clones.h"
#include "scene/noise_cell.h"

enum { CORNERS = 8 };

/* The unit cells that four points are in and the places in them. Corner c is on
 * the upper planes of x, y and z where bit 0, 1 and 2 of c are set. */
struct cells {
    uint32_t plane[3][2][FOUR]; /* per axis: the lower and the upper */
    float place[3][FOUR];
    float weight[CORNERS][FOUR];
};

static inline void cells_weigh(struct cells *cells, const floats blend[3])
{
    floats rest[3] = { 1 - blend[0], 1 - blend[1], 1 - blend[2] };
    floats weight[4] = { rest[0] * rest[1], blend[0] * rest[1],
                         rest[0] * blend[1], blend[0] * blend[1] };
    for (int i = 0; i < 4; i++) {
        floats below = weight[i] * rest[2], above = weight[i] * blend[2];
        memcpy(cells->weight[i], &below, sizeof below);
        memcpy(cells->weight[i + 4], &above, sizeof above);
    }
}

static inline void cells_place(struct cells *cells, const planes low[3],
                               const floats place[3])
{
    floats blend[3];
    for (int axis = 0; axis < 3; axis++) {
        planes below = lattice_planes(low[axis]);
        planes above = lattice_planes(low[axis] + 1);
        floats t = place[axis];
        memcpy(cells->plane[axis][0], &below, sizeof below);
        memcpy(cells->plane[axis][1], &above, sizeof above);
        memcpy(cells->place[axis], &t, sizeof t);
        blend[axis] = t * t * (3 - 2 * t);
    }
    cells_weigh(cells, blend);
}

static void cells_wrapped(const struct four at[3], planes low[3],
                          floats place[3])
{
    for (int axis = 0; axis < 3; axis++) {
        struct four wrapped = at[axis];
        for (int i = 0; i < PAIR; i++) {
            wrapped.low[i] = plane_wrapped(wrapped.low[i]);
            wrapped.high[i] = plane_wrapped(wrapped.high[i]);
        }
        low[axis] = planes_below(wrapped, &place[axis]);
    }
}

static inline void cells_at(struct cells *cells, const struct four at[3])
{
    planes low[3];
    floats place[3];
    for (int axis = 0; axis < 3; axis++)
        low[axis] = planes_below(at[axis], &place[axis]);
    if (planes_lost(low[0], low[1], low[2]))
        cells_wrapped(at, low, place);
    cells_place(cells, low, place);
}

/* One of them. */
struct cell {
    uint32_t plane[3][2];
    float place[3], weight[CORNERS];
};

static inline struct cell cell_of(const struct cells *cells, int i)
{
    struct cell cell;
    for (int axis = 0; axis < 3; axis++) {
        cell.plane[axis][0] = cells->plane[axis][0][i];
        cell.plane[axis][1] = cells->plane[axis][1][i];
        cell.place[axis] = cells->place[axis][i];
    }
    for (int c = 0; c < CORNERS; c++)
        cell.weight[c] = cells->weight[c][i];
    return cell;
}

/* The cell of a single point: its three coordinates at a time. */
static inline struct cell cell_at(double x, double y, double z)
{
    struct cell cell;
    floats place;
    planes low = planes_below((struct four){ { x, y }, { z, z } }, &place);
    if (planes_lost(low, low, low))
        low = planes_below(
            (struct four){ { plane_wrapped(x), plane_wrapped(y) },
                           { plane_wrapped(z), plane_wrapped(z) } },
            &place);
    planes below = lattice_planes(low), above = lattice_planes(low + 1);
    floats blend = place * place * (3 - 2 * place), rest = 1 - blend;
    for (int axis = 0; axis < 3; axis++) {
        cell.plane[axis][0] = below[axis];
        cell.plane[axis][1] = above[axis];
        cell.place[axis] = place[axis];
    }
    for (int c = 0; c < CORNERS; c++)
        cell.weight[c] = (c & 1 ? blend[0] : rest[0]) *
                         (c & 2 ? blend[1] : rest[1]) *
                         (c & 4 ? blend[2] : rest[2]);
    return cell;
}

/* The numbers that a corner stands for, by the hash of its x and y. */
static inline const float *corner_window(const struct noise_tables *tables,
                                         uint32_t hash, uint32_t z)
{
    return tables->windows[tables->permutation[hash ^ z] % NOISE_WINDOWS];
}

/* Where those of the corners of a cell are. */
static inline void cell_windows(const struct noise_tables *tables,
                                const struct cell *cell,
                                const float *windows[CORNERS])
{
    const uint16_t *permutation = tables->permutation;
    const uint32_t *y = cell->plane[1], *z = cell->plane[2];
    uint32_t low = permutation[cell->plane[0][0]];
    uint32_t high = permutation[cell->plane[0][1]];
    uint32_t hash[4] = { permutation[low ^ y[0]], permutation[high ^ y[0]],
                         permutation[low ^ y[1]], permutation[high ^ y[1]] };
    for (int c = 0; c < 4; c++) {
        windows[c] = corner_window(tables, hash[c], z[0]);
        windows[c + 4] = corner_window(tables, hash[c], z[1]);
    }
}

/* A corner's four numbers of each field, and four more that nobody wants: in
 * one instruction where there are such wide ones. */
typedef float wide __attribute__((vector_size(NOISE_ROOM * sizeof(float))));

_Static_assert(NOISE_FIELD_STEP == 4 && NOISE_ROOM == 16 && NOISE_FIELDS <= 4,
               "fields are read side by side");

INLINED floats fields_at(const wide *sum, int field)
{
    floats four;
    memcpy(&four, (const char *)sum + (size_t)field * sizeof four, sizeof four);
    return four;
}

/* Of three fields the sums of their four numbers, in that order. */
INLINED floats fields_total(const wide *sum)
{
    const floats a = fields_at(sum, 0), b = fields_at(sum, 1),
                 c = fields_at(sum, 2);
    const floats ab = __builtin_shufflevector(a, b, 0, 4, 1, 5);
    const floats ab_rest = __builtin_shufflevector(a, b, 2, 6, 3, 7);
    const floats first = __builtin_shufflevector(ab, c, 0, 1, 4, 4);
    const floats second = __builtin_shufflevector(ab, c, 2, 3, 5, 5);
    const floats third = __builtin_shufflevector(ab_rest, c, 0, 1, 6, 6);
    const floats fourth = __builtin_shufflevector(ab_rest, c, 2, 3, 7, 7);
    return first + second + third + fourth;
}

/* The three fields of a cell. The corners are added in a fixed order. */
INLINED void cell_fields(const struct noise_tables *tables,
                         const struct cell *cell, float *out)
{
    const float *windows[CORNERS];
    const float x = cell->place[0], y = cell->place[1], z = cell->place[2];
    const wide place = { 0.5f, x, y, z, 0.5f, x, y, z,
                         0.5f, x, y, z, 0.5f, x, y, z };
    wide sum = { 0 };
    cell_windows(tables, cell, windows);
    for (int c = 0; c < CORNERS; c++) {
        const float i = (float)(c & 1), j = (float)(c >> 1 & 1),
                    k = (float)(c >> 2);
        const wide origin = { 0, i, j, k, 0, i, j, k, 0, i, j, k, 0, i, j, k };
        wide random;
        memcpy(&random, windows[c], sizeof random);
        sum += (place - origin) * cell->weight[c] * random;
    }
    const floats total = fields_total(&sum);
    for (int field = 0; field < NOISE_FIELDS; field++)
        out[field] = total[field];
}

/* The first alone. */
INLINED void cell_field(const struct noise_tables *tables,
                        const struct cell *cell, float *out)
{
    const float *windows[CORNERS];
    floats sum = { 0 };
    floats place = { 0.5f, cell->place[0], cell->place[1], cell->place[2] };
    cell_windows(tables, cell, windows);
    for (int c = 0; c < CORNERS; c++) {
        const floats origin = { 0, (float)(c & 1), (float)(c >> 1 & 1),
                                (float)(c >> 2) };
        floats random;
        memcpy(&random, windows[c], sizeof random);
        sum += (place - origin) * cell->weight[c] * random;
    }
    *out = sum[0] + sum[1] + sum[2] + sum[3];
}

INLINED void cell_blend(const struct noise_tables *tables,
                        const struct cell *cell, int count, float *out)
{
    if (count == NOISE_FIELDS)
        cell_fields(tables, cell, out);
    else
        cell_field(tables, cell, out);
}

/* Four from number i on; where there are fewer, the last again. */
static inline struct four four_from(const double *at, int i, int last)
{
    return (struct four){ { at[i], at[i + 1 < last ? i + 1 : last] },
                          { at[i + 2 < last ? i + 2 : last],
                            at[i + 3 < last ? i + 3 : last] } };
}

/* Of each point `fields` numbers. */
INLINED void noise_blend(struct coordinates at, int count, int fields,
                         float *out)
{
    const struct noise_tables *tables = noise_tables();
    struct cells cells;
    if (count == 1) {
        struct cell alone = cell_at(at.x[0], at.y[0], at.z[0]);
        cell_blend(tables, &alone, fields, out);
        return;
    }
    for (int i = 0; i < count; i += FOUR) {
        const struct four four[3] = { four_from(at.x, i, count - 1),
                                      four_from(at.y, i, count - 1),
                                      four_from(at.z, i, count - 1) };
        int here = count - i < FOUR ? count - i : FOUR;
        cells_at(&cells, four);
        for (int k = 0; k < here; k++) {
            struct cell cell = cell_of(&cells, k);
            cell_blend(tables, &cell, fields, out + (i + k) * fields);
        }
    }
}

CLONES void lattice_noise(struct coordinates at, int count, float *raw)
{
    noise_blend(at, count, 1, raw);
}

CLONES void lattice_noise_fields(struct coordinates at, int count,
                                 float (*raw)[NOISE_FIELDS])
{
    noise_blend(at, count, NOISE_FIELDS, raw[0]);
}

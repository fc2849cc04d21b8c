/* Solid noise: K. Perlin, "An Image Synthesizer", SIGGRAPH 1985. Each point of
 * the integer lattice has a random value and a random gradient; between them
 * the eight linear functions are blended by 3t^2 - 2t^3. The random numbers are
 * POV-Ray's (scene/noise_tables).
 *
 * Where points are in their cells is worked out for eight at a time, and for
 * many of them before the first is asked for: no step of it waits long for the
 * one before. What the corners of a cell add up to follows for one point after
 * the other, a corner's value and gradient of all fields at a time, since
 * gathering numbers for several takes longer. Eight points in one cell, as
 * neighbours are in the first octaves, have it added up together. */
#include "scene/lattice_noise.h"

#include <string.h>

#include "base/clones.h"
#include "scene/noise_cell.h"

enum { CORNERS = 8, STEP = LATTICE_STEP };

typedef double doubles __attribute__((vector_size(8 * STEP)));
typedef uint64_t words __attribute__((vector_size(8 * STEP)));
typedef float floats __attribute__((vector_size(4 * STEP)));
typedef float quad __attribute__((vector_size(16)));

/* ---- cells ---- */

/* The unit cells that eight points are in and the places in them. Corner c is
 * on the upper planes of x, y and z where bit 0, 1 and 2 of c are set. */
struct cells {
    LANE_LINES uint64_t plane[3][2][STEP]; /* per axis: the lower, the upper */
    float place[3][STEP];
    float weight[CORNERS][STEP];
    bool one; /* all of them are in the same one */
};

/* How far coordinates are above the planes below them, whose numbers are in the
 * low bits of `low`. Numbers so big have no fraction: adding one rounds to the
 * nearest plane of what is half a unit less, at a tie the even one. An odd
 * plane so becomes the upper end of the cell below, where the noise is the
 * same. */
INLINED floats planes_below(doubles at, words *low)
{
    const double big = 0x1.8p52;
    doubles rounded = (at - 0.5) + big;
    *low = (words)rounded;
    return __builtin_convertvector(at - (rounded - big), floats);
}

/* Of planes as they are found: not 0 where there is none, since the coordinate
 * is beyond 2^51 or no number and the sum has another exponent. */
INLINED words planes_lost(words low)
{
    return low >> 52 ^ 0x433;
}

INLINED bool any(words bits)
{
    return ((bits[0] | bits[1]) | (bits[2] | bits[3]) |
            ((bits[4] | bits[5]) | (bits[6] | bits[7]))) != 0;
}

/* A coordinate that isn't lost, on a lattice that begins anew after 2^20
 * planes, or 2^12. Exact: from 2^30 on a double has 22 bits for its fraction.
 */
static double plane_wrapped(double at)
{
    if (fabs(at) < 0x1p30)
        return at;
    int64_t low = plane_below(&at);
    return (double)(low & 0xfffff) + (at - (double)low);
}

INLINED floats places_blend(floats place)
{
    return place * place * (3 - 2 * place);
}

INLINED void cells_weigh(struct cells *cells, const floats blend[3])
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

INLINED void cells_place(struct cells *cells, const doubles at[3], words *lost)
{
    floats blend[3];
    words differ = { 0 };
    for (int axis = 0; axis < 3; axis++) {
        words low;
        floats place = planes_below(at[axis], &low);
        differ |= low ^ low[0];
        words below = (low + LATTICE_ORIGIN) & LATTICE_MASK;
        words above = (low + (LATTICE_ORIGIN + 1)) & LATTICE_MASK;
        memcpy(cells->plane[axis][0], &below, sizeof below);
        memcpy(cells->plane[axis][1], &above, sizeof above);
        memcpy(cells->place[axis], &place, sizeof place);
        *lost |= planes_lost(low);
        blend[axis] = places_blend(place);
    }
    cells->one = !any(differ);
    cells_weigh(cells, blend);
}

/* The eight points from number i on; 0 for those that there aren't. */
INLINED void step_points(doubles step[3], struct coordinates at, int i,
                         int count)
{
    static const int64_t chosen[2 * STEP] = { -1, -1, -1, -1, -1, -1, -1, -1 };
    const double *from[3] = { at.x + i, at.y + i, at.z + i };
    int here = count - i < STEP ? count - i : STEP;
    words mask;
    memcpy(&mask, chosen + STEP - here, sizeof mask);
    for (int axis = 0; axis < 3; axis++) {
        words read;
        memcpy(&read, from[axis], sizeof read);
        step[axis] = (doubles)(read & mask);
    }
}

/* So many points' cells are found before they are asked. */
enum { CELLS = 4 };

/* The same for points of which some are lost. */
static __attribute__((noinline)) void cells_wrapped(struct cells cells[CELLS],
                                                    struct coordinates at,
                                                    int from, int count)
{
    words lost = { 0 };
    for (int i = from; i < count && i < from + CELLS * STEP; i += STEP) {
        doubles step[3];
        step_points(step, at, i, count);
        for (int axis = 0; axis < 3; axis++)
            for (int k = 0; k < STEP; k++)
                step[axis][k] = plane_wrapped(step[axis][k]);
        cells_place(&cells[(i - from) / STEP], step, &lost);
    }
}

/* Those of the points from number `from` on; returns of how many. */
INLINED int cells_find(struct cells cells[CELLS], struct coordinates at,
                       int from, int count)
{
    int some = count - from < CELLS * STEP ? count - from : CELLS * STEP;
    words lost = { 0 };
    for (int i = 0; i < some; i += STEP) {
        doubles step[3];
        step_points(step, at, from + i, count);
        cells_place(&cells[i / STEP], step, &lost);
    }
    if (any(lost))
        cells_wrapped(cells, at, from, count);
    return some;
}

/* One of them. */
struct cell {
    uint32_t plane[3][2];
    float place[3], weight[CORNERS];
};

INLINED struct cell cell_of(const struct cells *cells, int i)
{
    struct cell cell;
    for (int axis = 0; axis < 3; axis++) {
        cell.plane[axis][0] = (uint32_t)cells->plane[axis][0][i];
        cell.plane[axis][1] = (uint32_t)cells->plane[axis][1][i];
        cell.place[axis] = cells->place[axis][i];
    }
    for (int c = 0; c < CORNERS; c++)
        cell.weight[c] = cells->weight[c][i];
    return cell;
}

/* The cell of a single point: its three coordinates at a time. */
INLINED struct cell cell_at(double x, double y, double z)
{
    struct cell cell;
    words low;
    floats place = planes_below((doubles){ x, y, z }, &low);
    if (any(planes_lost(low)))
        place = planes_below(
            (doubles){ plane_wrapped(x), plane_wrapped(y), plane_wrapped(z) },
            &low);
    floats blend = places_blend(place), rest = 1 - blend;
    for (int axis = 0; axis < 3; axis++) {
        cell.plane[axis][0] = lattice_plane((int64_t)low[axis]);
        cell.plane[axis][1] = lattice_plane((int64_t)low[axis] + 1);
        cell.place[axis] = place[axis];
    }
    for (int c = 0; c < CORNERS; c++)
        cell.weight[c] = (c & 1 ? blend[0] : rest[0]) *
                         (c & 2 ? blend[1] : rest[1]) *
                         (c & 4 ? blend[2] : rest[2]);
    return cell;
}

/* ---- their corners ---- */

/* The window that a corner looks into, by the hash of its x and y. */
INLINED uint32_t corner_window(const struct noise_tables *tables, uint32_t hash,
                               uint32_t z)
{
    return tables->permutation[hash ^ z] % NOISE_WINDOWS;
}

INLINED void cell_windows(const struct noise_tables *tables,
                          const struct cell *cell, uint32_t windows[CORNERS])
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

/* What a corner's numbers are multiplied by before they are added up: 1/2 for
 * its value and the place for its gradient, as often as there are fields. */
struct factors {
    LANE_LINES float of[NOISE_NUMBERS][NOISE_ROOM];
};

/* All of them, in one register where there are such wide ones. Those are put
 * together in memory: compilers do it badly elsewhere. */
typedef float wide __attribute__((vector_size(sizeof(struct factors))));

_Static_assert(sizeof(struct factors) == NOISE_NUMBERS * sizeof(quad) &&
                   (int)NOISE_FIELDS <= (int)NOISE_ROOM,
               "numbers are read side by side");

INLINED void factors_fill(struct factors *factors, const struct cell *cell)
{
    for (int number = 0; number < NOISE_NUMBERS; number++) {
        float one = number == 0 ? 0.5f : cell->place[number - 1];
        quad same = { one, one, one, one };
        memcpy(factors->of[number], &same, sizeof same);
    }
}

INLINED quad wide_part(const wide *sum, int i)
{
    quad four;
    memcpy(&four, (const char *)sum + (size_t)i * sizeof four, sizeof four);
    return four;
}

/* The three fields of a cell. The corners are added in a fixed order. */
INLINED void cell_fields(const struct noise_tables *tables,
                         const struct cell *cell, const struct factors *factors,
                         float out[NOISE_ROOM])
{
    uint32_t windows[CORNERS];
    wide place, sum = { 0 };
    memcpy(&place, factors, sizeof place);
    cell_windows(tables, cell, windows);
    for (int c = 0; c < CORNERS; c++) {
        const float i = (float)(c & 1), j = (float)(c >> 1 & 1),
                    k = (float)(c >> 2);
        const wide origin = { 0, 0, 0, 0, i, i, i, i, j, j, j, j, k, k, k, k };
        wide random;
        memcpy(&random, tables->fields[windows[c]], sizeof random);
        sum += (place - origin) * cell->weight[c] * random;
    }
    quad total = wide_part(&sum, 0) + wide_part(&sum, 1) + wide_part(&sum, 2) +
                 wide_part(&sum, 3);
    memcpy(out, &total, sizeof total);
}

/* Of the first field the four sums that are its noise together. */
INLINED quad cell_sums(const struct noise_tables *tables,
                       const struct cell *cell)
{
    uint32_t windows[CORNERS];
    quad sum = { 0 };
    quad place = { 0.5f, cell->place[0], cell->place[1], cell->place[2] };
    cell_windows(tables, cell, windows);
    for (int c = 0; c < CORNERS; c++) {
        const quad origin = { 0, (float)(c & 1), (float)(c >> 1 & 1),
                              (float)(c >> 2) };
        quad random;
        memcpy(&random, tables->first[windows[c]], sizeof random);
        sum += (place - origin) * cell->weight[c] * random;
    }
    return sum;
}

/* The noise of eight points in one cell: the same sums in the same order, one
 * lane to each point. */
INLINED floats cell_shared(const struct noise_tables *tables,
                           const struct cells *cells)
{
    uint32_t windows[CORNERS];
    floats place[3], sum[NOISE_NUMBERS] = { { 0 } };
    struct cell cell = cell_of(cells, 0);
    memcpy(place, cells->place, sizeof place);
    cell_windows(tables, &cell, windows);
    for (int c = 0; c < CORNERS; c++) {
        const float *random = tables->first[windows[c]];
        floats weight;
        memcpy(&weight, cells->weight[c], sizeof weight);
        sum[0] += 0.5f * weight * random[0];
        for (int axis = 0; axis < 3; axis++)
            sum[axis + 1] += (place[axis] - (float)(c >> axis & 1)) * weight *
                             random[axis + 1];
    }
    return sum[0] + sum[1] + sum[2] + sum[3];
}

/* Each of four sums' own total. */
INLINED quad sums_total(const quad sum[4])
{
    const quad a = __builtin_shufflevector(sum[0], sum[1], 0, 4, 1, 5);
    const quad b = __builtin_shufflevector(sum[2], sum[3], 0, 4, 1, 5);
    const quad c = __builtin_shufflevector(sum[0], sum[1], 2, 6, 3, 7);
    const quad d = __builtin_shufflevector(sum[2], sum[3], 2, 6, 3, 7);
    return __builtin_shufflevector(a, b, 0, 1, 4, 5) +
           __builtin_shufflevector(a, b, 2, 3, 6, 7) +
           __builtin_shufflevector(c, d, 0, 1, 4, 5) +
           __builtin_shufflevector(c, d, 2, 3, 6, 7);
}

/* ---- many points ---- */

/* Of up to eight points whose cells are these. */
INLINED void cells_noise(const struct noise_tables *tables,
                         const struct cells *cells, int count, float *raw)
{
    floats total;
    quad sum[STEP] = { { 0 } };
    if (cells->one) {
        total = cell_shared(tables, cells);
    } else {
#pragma GCC unroll 1
        for (int k = 0; k < count; k++) {
            struct cell cell = cell_of(cells, k);
            sum[k] = cell_sums(tables, &cell);
        }
        total = __builtin_shufflevector(sums_total(sum), sums_total(sum + 4), 0,
                                        1, 2, 3, 4, 5, 6, 7);
    }
    memcpy(raw, &total, (size_t)count * sizeof *raw);
}

CLONES void lattice_noise(struct coordinates at, int count, float *raw)
{
    const struct noise_tables *tables = noise_tables();
    struct cells cells[CELLS];
    if (count == 1) {
        struct cell alone = cell_at(at.x[0], at.y[0], at.z[0]);
        quad sum = cell_sums(tables, &alone);
        *raw = sum[0] + sum[1] + sum[2] + sum[3];
        return;
    }
    for (int from = 0, some; from < count; from += some) {
        some = cells_find(cells, at, from, count);
        for (int i = 0; i < some; i += STEP)
            cells_noise(tables, &cells[i / STEP],
                        some - i < STEP ? some - i : STEP, raw + from + i);
    }
}

CLONES void lattice_noise_fields(struct coordinates at, int count,
                                 float (*raw)[NOISE_ROOM])
{
    const struct noise_tables *tables = noise_tables();
    struct cells cells[CELLS];
    struct factors factors[CELLS * STEP];
    if (count == 1) {
        struct cell alone = cell_at(at.x[0], at.y[0], at.z[0]);
        factors_fill(factors, &alone);
        cell_fields(tables, &alone, factors, raw[0]);
        return;
    }
    for (int from = 0, some; from < count; from += some) {
        some = cells_find(cells, at, from, count);
        for (int i = 0; i < some; i++) {
            struct cell cell = cell_of(&cells[i / STEP], i % STEP);
            factors_fill(&factors[i], &cell);
        }
        for (int i = 0; i < some; i++) {
            struct cell cell = cell_of(&cells[i / STEP], i % STEP);
            cell_fields(tables, &cell, &factors[i], raw[from + i]);
        }
    }
}

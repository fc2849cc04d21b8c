/* Solid noise: K. Perlin, "An Image Synthesizer", SIGGRAPH 1985. Each point of
 * the integer lattice has a random value and a random gradient; between them
 * the eight linear functions are blended by 3t^2 - 2t^3. The random numbers are
 * POV-Ray's (scene/noise_tables).
 *
 * Where points are in their cells is worked out for four at a time, and for
 * many of them before the first is asked for: no step of it waits long for the
 * one before. What the corners of a cell add up to follows for one point after
 * the other, a corner's value and gradient of all fields at a time, since
 * gathering numbers for four takes longer. */
#include "scene/lattice_noise.h"

#include <string.h>

#include "base/clones.h"
#include "scene/noise_cell.h"

enum { CORNERS = 8, FOUR = LATTICE_STEP };

typedef double doubles __attribute__((vector_size(8 * FOUR)));
typedef uint64_t words __attribute__((vector_size(8 * FOUR)));
typedef float floats __attribute__((vector_size(4 * FOUR)));

/* ---- cells ---- */

/* The unit cells that four points are in and the places in them. Corner c is on
 * the upper planes of x, y and z where bit 0, 1 and 2 of c are set. */
struct cells {
    LANE_LINES uint64_t plane[3][2][FOUR]; /* per axis: the lower, the upper */
    float place[3][FOUR];
    float weight[CORNERS][FOUR];
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

INLINED bool any_lost(words lost)
{
    return (lost[0] | lost[1] | lost[2] | lost[3]) != 0;
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
    for (int axis = 0; axis < 3; axis++) {
        words low;
        floats place = planes_below(at[axis], &low);
        words below = (low + LATTICE_ORIGIN) & LATTICE_MASK;
        words above = (low + (LATTICE_ORIGIN + 1)) & LATTICE_MASK;
        memcpy(cells->plane[axis][0], &below, sizeof below);
        memcpy(cells->plane[axis][1], &above, sizeof above);
        memcpy(cells->place[axis], &place, sizeof place);
        *lost |= planes_lost(low);
        blend[axis] = places_blend(place);
    }
    cells_weigh(cells, blend);
}

/* The four points from number i on; 0 for those that there aren't. */
INLINED void four_points(doubles four[3], struct coordinates at, int i,
                         int count)
{
    static const int64_t chosen[2 * FOUR] = { -1, -1, -1, -1 };
    const double *from[3] = { at.x + i, at.y + i, at.z + i };
    int here = count - i < FOUR ? count - i : FOUR;
    words mask;
    memcpy(&mask, chosen + FOUR - here, sizeof mask);
    for (int axis = 0; axis < 3; axis++) {
        words read;
        memcpy(&read, from[axis], sizeof read);
        four[axis] = (doubles)(read & mask);
    }
}

/* So many points' cells are found before they are asked. */
enum { CELLS = 8 };

/* The same for points of which some are lost. */
static __attribute__((noinline)) void cells_wrapped(struct cells cells[CELLS],
                                                    struct coordinates at,
                                                    int from, int count)
{
    words lost = { 0 };
    for (int i = from; i < count && i < from + CELLS * FOUR; i += FOUR) {
        doubles four[3];
        four_points(four, at, i, count);
        for (int axis = 0; axis < 3; axis++)
            for (int k = 0; k < FOUR; k++)
                four[axis][k] = plane_wrapped(four[axis][k]);
        cells_place(&cells[(i - from) / FOUR], four, &lost);
    }
}

/* Those of the points from number `from` on; returns of how many. */
INLINED int cells_find(struct cells cells[CELLS], struct coordinates at,
                       int from, int count)
{
    int some = count - from < CELLS * FOUR ? count - from : CELLS * FOUR;
    words lost = { 0 };
    for (int i = 0; i < some; i += FOUR) {
        doubles four[3];
        four_points(four, at, from + i, count);
        cells_place(&cells[i / FOUR], four, &lost);
    }
    if (any_lost(lost))
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
    floats place = planes_below((doubles){ x, y, z, z }, &low);
    if (any_lost(planes_lost(low)))
        place = planes_below((doubles){ plane_wrapped(x), plane_wrapped(y),
                                        plane_wrapped(z), 0 },
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

_Static_assert(sizeof(struct factors) == FOUR * sizeof(floats) &&
                   (int)NOISE_FIELDS <= (int)NOISE_ROOM,
               "numbers are read side by side");

INLINED void factors_fill(struct factors *factors, const struct cell *cell)
{
    for (int number = 0; number < NOISE_NUMBERS; number++) {
        float one = number == 0 ? 0.5f : cell->place[number - 1];
        floats same = { one, one, one, one };
        memcpy(factors->of[number], &same, sizeof same);
    }
}

INLINED floats wide_part(const wide *sum, int i)
{
    floats four;
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
    floats total = wide_part(&sum, 0) + wide_part(&sum, 1) +
                   wide_part(&sum, 2) + wide_part(&sum, 3);
    memcpy(out, &total, sizeof total);
}

/* Of the first field the four sums that are its noise together. */
INLINED floats cell_sums(const struct noise_tables *tables,
                         const struct cell *cell)
{
    uint32_t windows[CORNERS];
    floats sum = { 0 };
    floats place = { 0.5f, cell->place[0], cell->place[1], cell->place[2] };
    cell_windows(tables, cell, windows);
    for (int c = 0; c < CORNERS; c++) {
        const floats origin = { 0, (float)(c & 1), (float)(c >> 1 & 1),
                                (float)(c >> 2) };
        floats random;
        memcpy(&random, tables->first[windows[c]], sizeof random);
        sum += (place - origin) * cell->weight[c] * random;
    }
    return sum;
}

/* Each of four sums' own total. */
INLINED floats sums_total(const floats sum[4])
{
    const floats a = __builtin_shufflevector(sum[0], sum[1], 0, 4, 1, 5);
    const floats b = __builtin_shufflevector(sum[2], sum[3], 0, 4, 1, 5);
    const floats c = __builtin_shufflevector(sum[0], sum[1], 2, 6, 3, 7);
    const floats d = __builtin_shufflevector(sum[2], sum[3], 2, 6, 3, 7);
    return __builtin_shufflevector(a, b, 0, 1, 4, 5) +
           __builtin_shufflevector(a, b, 2, 3, 6, 7) +
           __builtin_shufflevector(c, d, 0, 1, 4, 5) +
           __builtin_shufflevector(c, d, 2, 3, 6, 7);
}

/* ---- many points ---- */

/* Of up to four points whose cells are these. */
INLINED void cells_noise(const struct noise_tables *tables,
                         const struct cells *cells, int count, float *raw)
{
    floats sum[FOUR] = { { 0 } };
#pragma GCC unroll 1
    for (int k = 0; k < count; k++) {
        struct cell cell = cell_of(cells, k);
        sum[k] = cell_sums(tables, &cell);
    }
    floats total = sums_total(sum);
    if (count == FOUR)
        memcpy(raw, &total, sizeof total);
    else
        memcpy(raw, &total, (size_t)count * sizeof *raw);
}

CLONES void lattice_noise(struct coordinates at, int count, float *raw)
{
    const struct noise_tables *tables = noise_tables();
    struct cells cells[CELLS];
    if (count == 1) {
        struct cell alone = cell_at(at.x[0], at.y[0], at.z[0]);
        floats sum = cell_sums(tables, &alone);
        *raw = sum[0] + sum[1] + sum[2] + sum[3];
        return;
    }
    for (int from = 0, some; from < count; from += some) {
        some = cells_find(cells, at, from, count);
        for (int i = 0; i < some; i += FOUR)
            cells_noise(tables, &cells[i / FOUR],
                        some - i < FOUR ? some - i : FOUR, raw + from + i);
    }
}

CLONES void lattice_noise_fields(struct coordinates at, int count,
                                 float (*raw)[NOISE_ROOM])
{
    const struct noise_tables *tables = noise_tables();
    struct cells cells[CELLS];
    struct factors factors[CELLS * FOUR];
    if (count == 1) {
        struct cell alone = cell_at(at.x[0], at.y[0], at.z[0]);
        factors_fill(factors, &alone);
        cell_fields(tables, &alone, factors, raw[0]);
        return;
    }
    for (int from = 0, some; from < count; from += some) {
        some = cells_find(cells, at, from, count);
        for (int i = 0; i < some; i++) {
            struct cell cell = cell_of(&cells[i / FOUR], i % FOUR);
            factors_fill(&factors[i], &cell);
        }
        for (int i = 0; i < some; i++) {
            struct cell cell = cell_of(&cells[i / FOUR], i % FOUR);
            cell_fields(tables, &cell, &factors[i], raw[from + i]);
        }
    }
}

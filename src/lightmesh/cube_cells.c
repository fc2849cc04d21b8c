/* Triangles on the sides of a cube: see cube_cells.h. */
#include "lightmesh/cube_cells.h"

#include <math.h>
#include <string.h>

/* Corners that a triangle may have when four planes have cut it. */
enum { CORNERS_MOST = 9 };

/* A triangle as a polygon that is cut. */
struct cube_polygon {
    int count;
    float corner[CORNERS_MOST][3];
};

/* Leaves what of it is on the positive side of depth + sign * across. */
static void polygon_cut(struct cube_polygon *polygon, int depth, float facing,
                        int across, float sign)
{
    struct cube_polygon old = *polygon;
    polygon->count = 0;
    for (int i = 0; i < old.count; i++) {
        const float *a = old.corner[i], *b = old.corner[(i + 1) % old.count];
        float from = facing * a[depth] + sign * a[across];
        float to = facing * b[depth] + sign * b[across];
        if (from >= 0 && polygon->count < CORNERS_MOST)
            memcpy(polygon->corner[polygon->count++], a, 3 * sizeof *a);
        if ((from >= 0) == (to >= 0) || polygon->count == CORNERS_MOST)
            continue;
        float *cut = polygon->corner[polygon->count++];
        for (int k = 0; k < 3; k++)
            cut[k] = a[k] + from / (from - to) * (b[k] - a[k]);
    }
}

static int cell_within(float place, int edge)
{
    return place > 0 ? (place < (float)(edge - 1) ? (int)place : edge - 1) : 0;
}

/* Whether all corners are outside of one of the four planes between which the
 * side is. */
static bool polygon_misses(const struct cube_polygon *polygon, int depth,
                           float facing, int across)
{
    bool low = true, high = true;
    for (int i = 0; i < polygon->count; i++) {
        float far = facing * polygon->corner[i][depth];
        low = low && far < -polygon->corner[i][across];
        high = high && far < polygon->corner[i][across];
    }
    return low || high;
}

bool cube_box_of(const float triangle[3][3], int side, int edge,
                 struct cube_box *box)
{
    int depth = side / 2, u = depth == 0 ? 1 : 0, v = depth == 2 ? 1 : 2;
    float facing = side % 2 ? -1.0f : 1.0f, half = (float)edge / 2;
    float low[2] = { HUGE_VALF, HUGE_VALF };
    float high[2] = { -HUGE_VALF, -HUGE_VALF };
    struct cube_polygon cut = { .count = 3 };
    memcpy(cut.corner, triangle, 3 * sizeof *cut.corner);
    if (polygon_misses(&cut, depth, facing, u) ||
        polygon_misses(&cut, depth, facing, v))
        return false;
    bool before = true;
    for (int i = 0; i < cut.count; i++)
        before = before && facing * cut.corner[i][depth] > 0;
    for (int k = 0; !before && k < 4 && cut.count > 0; k++)
        polygon_cut(&cut, depth, facing, k < 2 ? u : v, k % 2 ? -1.0f : 1.0f);
    if (cut.count == 0)
        return false;
    for (int i = 0; i < cut.count; i++) {
        const float *corner = cut.corner[i];
        float scale = half / (facing * corner[depth]);
        const float at[2] = { corner[u] * scale + half,
                              corner[v] * scale + half };
        for (int k = 0; k < 2; k++) {
            low[k] = fminf(low[k], at[k] - CELL_SLACK);
            high[k] = fmaxf(high[k], at[k] + CELL_SLACK);
        }
    }
    *box = (struct cube_box){ side, cell_within(low[0], edge),
                              cell_within(low[1], edge),
                              cell_within(high[0], edge),
                              cell_within(high[1], edge) };
    return true;
}

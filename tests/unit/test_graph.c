/* skeleton/graph, paths, chamber, pieces and enclosure: voids whose skeleton is
 * known, and enclosures whose light is. */
#include <math.h>

#include "harness.h"
#include "base/memory.h"
#include "skeleton/chamber.h"
#include "skeleton/collapse.h"
#include "skeleton/distance.h"
#include "skeleton/enclosure.h"
#include "skeleton/opening.h"
#include "skeleton/paths.h"
#include "skeleton/pieces.h"
#include "voids.h"

static void assert_close(double value, double wanted, double tolerance)
{
    if (!(fabs(value - wanted) <= tolerance))
        fail_msg("%.17g, not %.17g", value, wanted);
}

struct fixture {
    struct arena *arena;
    struct voxels voxels;
    struct graph *graph;
    uint32_t *nearest;
};

static struct fixture fixture_new(const struct void_case *what, bool rough)
{
    struct fixture f = { .arena = arena_new(0), .voxels = void_case_new(what) };
    if (rough)
        void_case_roughen(&f.voxels, 1);
    size_t count = voxels_count(&f.voxels);
    uint16_t *distance = ARENA_ARRAY(f.arena, uint16_t, count);
    uint16_t *opening = ARENA_ARRAY(f.arena, uint16_t, count);
    int32_t *squared = ARENA_ARRAY(f.arena, int32_t, count);
    struct collapse_maps maps = { distance, opening };
    struct complex *complex = complex_new(&f.voxels);
    distance_chessboard(&f.voxels, OUTSIDE_VOID, distance);
    opening_chessboard(&f.voxels, distance, 1, opening);
    distance_squared(&f.voxels, OUTSIDE_VOID, 1, squared);
    complex_collapse(complex, &f.voxels, &maps);
    f.graph = graph_new(f.arena, complex, &f.voxels, squared);
    f.nearest = ARENA_ARRAY(f.arena, uint32_t, count);
    graph_nearest(complex, &f.voxels, f.nearest);
    complex_free(complex);
    return f;
}

static void fixture_free(struct fixture *f)
{
    void_case_free(&f->voxels);
    arena_free(f->arena);
}

static bool in_void(const struct voxels *v, vec3 p)
{
    for (int i = 0; i < 8; i++) {
        double e = 1e-6 * v->edge;
        int x = (int)floor((p.x + (i & 1 ? e : -e) - v->origin.x) / v->edge);
        int y = (int)floor((p.y + (i & 2 ? e : -e) - v->origin.y) / v->edge);
        int z = (int)floor((p.z + (i & 4 ? e : -e) - v->origin.z) / v->edge);
        if (v->empty[voxels_index(v, x, y, z)])
            return true;
    }
    return false;
}

static void check_graph(const struct void_case *what, bool rough)
{
    struct fixture f = fixture_new(what, rough);
    size_t missing = 0;
    for (size_t i = 0; i < f.graph->count; i++) {
        assert_true(in_void(&f.voxels, f.graph->nodes[i].position));
        assert_true(f.graph->nodes[i].radius >= f.voxels.edge);
    }
    for (size_t i = 0; i < voxels_count(&f.voxels); i++) {
        bool has = f.nearest[i] != GRAPH_NONE;
        assert_true(f.voxels.empty[i] || !has);
        assert_true(!has || f.nearest[i] < f.graph->count);
        missing += f.voxels.empty[i] && !has;
    }
    /* Rough walls cut off corners that only touch the rest at an edge. */
    assert_in_range(missing, 0, rough ? 200 : 0);
    fixture_free(&f);
}

static void nodes_stay_in_the_void(void **state)
{
    (void)state;
    check_graph(&void_box, false);
    check_graph(&void_u, true);
    check_graph(&void_rooms, false);
    check_graph(&void_rooms, true);
    check_graph(&void_hall, false);
}

/* The way through the U: its length along the middle, ends excluded, and its
 * narrowest place. */
static void paths_along_the_u(void **state)
{
    (void)state;
    struct fixture f = fixture_new(&void_u, false);
    int place[3] = { 4, 14, 14 };
    uint32_t root =
        f.nearest[voxels_index(&f.voxels, place[0], place[1], place[2])];
    uint32_t far = f.nearest[voxels_index(&f.voxels, 4, 14, 86)];
    struct paths_from from = { .sources = &root, .count = 1 };
    const struct paths *paths = paths_new(f.arena, f.graph, &from);
    double straight = 0;
    assert_true(paths->parent[root] == GRAPH_NONE);
    assert_true(paths->distance[root] == 0);
    for (uint32_t at = far; at != root; at = paths->parent[at]) {
        double step = graph_length(f.graph, at, paths->parent[at]);
        straight += step;
        assert_true(paths->distance[paths->parent[at]] < paths->distance[at]);
    }
    assert_close(straight, (double)paths->distance[far], 1e-4);
    assert_in_range(straight * 1000, 15000, 20000);
    assert_true(paths->narrow[far] > 0.8f && paths->narrow[far] <= 1);
    fixture_free(&f);
}

/* Three rooms, a corridor, doors between; a room's two ends differ little. */
static void chambers_end_at_doors(void **state)
{
    (void)state;
    struct fixture f = fixture_new(&void_rooms, false);
    const struct chambers *c = chambers_new(f.arena, f.graph);
    const struct voxels *v = &f.voxels;
    uint32_t first = c->of_node[f.nearest[voxels_index(v, 20, 16, 20)]];
    uint32_t third = c->of_node[f.nearest[voxels_index(v, 90, 16, 26)]];
    uint32_t corridor = c->of_node[f.nearest[voxels_index(v, 52, 16, 50)]];
    assert_in_range(c->count, 4, 20);
    assert_int_not_equal(first, third);
    assert_int_not_equal(first, corridor);
    assert_int_equal(first, c->of_node[f.nearest[voxels_index(v, 5, 5, 36)]]);
    fixture_free(&f);
}

/* Of a long corridor every piece is a cell or less, within its chamber, and all
 * of the void is in one. */
static void pieces_fill_the_void(void **state)
{
    (void)state;
    struct fixture f = fixture_new(&void_u, false);
    const struct voxels *v = &f.voxels;
    struct pieces *p = pieces_new(f.arena, v, f.nearest, f.graph, NULL);
    uint32_t least = PIECE_NONE, most = 0;
    for (size_t i = 0; i < voxels_count(v); i++) {
        int at[3];
        voxels_place(v, i, at);
        assert_int_equal(p->of_voxel[i] == PIECE_NONE, !v->empty[i]);
        if (!v->empty[i])
            continue;
        const struct piece_cells *c = &p->cells[p->region[p->of_voxel[i]]];
        for (int axis = 0; axis < 3; axis++)
            assert_true(c->low[axis] <= at[axis] && at[axis] < c->high[axis]);
        least = p->of_voxel[i] < least ? p->of_voxel[i] : least;
        most = p->of_voxel[i] > most ? p->of_voxel[i] : most;
    }
    assert_int_equal(least, 0);
    assert_int_equal(most + 1, p->count);
    /* 24 voxels wide, three arms of about 90, cells of about 9. */
    assert_in_range(p->count, 180, 320);
    fixture_free(&f);
}

/* Whether voxels of one piece of `parts` are all of one of `whole`, if they are
 * of any. */
static void assert_parts(const struct voxels *v, const struct pieces *parts,
                         const struct pieces *whole)
{
    uint32_t *of = memory_new((parts->count + 1) * sizeof *of);
    for (size_t i = 0; i < parts->count; i++)
        of[i] = PIECE_NONE;
    for (size_t i = 0; i < voxels_count(v); i++) {
        uint32_t part = parts->of_voxel[i], own = whole->of_voxel[i];
        if (part == PIECE_NONE || own == PIECE_NONE)
            continue;
        if (of[part] == PIECE_NONE)
            of[part] = own;
        assert_int_equal(of[part], own);
        assert_int_equal(parts->region[part], whole->region[own]);
    }
    memory_free(of);
}

/* A thing in the middle of the corridor: with it and without it the cells are
 * those of the other, though each would be cut differently alone. */
static void pieces_follow_a_root(void **state)
{
    (void)state;
    struct fixture open = fixture_new(&void_u, false);
    struct void_case boxed = void_u;
    boxed.boxes[3] = (struct void_box)REFILL(74, 92, 2, 20, 30, 70);
    struct fixture full = fixture_new(&boxed, false);
    const struct voxels *v = &full.voxels;
    struct pieces *own =
        pieces_new(open.arena, &open.voxels, open.nearest, open.graph, NULL);
    struct pieces *alone =
        pieces_new(full.arena, v, full.nearest, full.graph, NULL);
    struct pieces_kept *root = pieces_keep(own, &open.voxels);
    struct pieces_kept *other = pieces_keep(alone, v);
    struct pieces *with =
        pieces_new(full.arena, v, full.nearest, full.graph, root);
    struct pieces *without =
        pieces_new(open.arena, &open.voxels, open.nearest, open.graph, other);
    struct pieces *again =
        pieces_new(open.arena, &open.voxels, open.nearest, open.graph, root);
    size_t size = voxels_count(v) * sizeof *own->of_voxel;
    assert_int_not_equal(alone->count, own->count);
    assert_parts(v, with, own);
    assert_parts(&open.voxels, without, alone);
    assert_int_equal(without->count, alone->count);
    for (size_t i = 0; i < voxels_count(v); i++) {
        assert_int_equal(with->of_voxel[i] == PIECE_NONE, !v->empty[i]);
        assert_int_equal(without->of_voxel[i] == PIECE_NONE,
                         !open.voxels.empty[i]);
    }
    assert_memory_equal(again->of_voxel, own->of_voxel, size);
    memory_free(root);
    memory_free(other);
    fixture_free(&full);
    fixture_free(&open);
}

/* Sumpner: E = rho Phi / (S (1 - rho)). */
static void one_zone(void **state)
{
    (void)state;
    struct arena *arena = arena_new(0);
    struct enclosure *e = enclosure_new(arena, 1);
    rgb albedo = rgb_make(0.2, 0.5, 0.8);
    enclosure_wall(e, 0, 3, albedo, rgb_grey(2), rgb_grey(0));
    enclosure_wall(e, 0, 5, albedo, rgb_grey(0), rgb_grey(0));
    enclosure_solve(e);
    assert_close(e->zones[0].light.r, 0.2 * 6 / (8 * 0.8), 1e-9);
    assert_close(e->zones[0].light.g, 0.5 * 6 / (8 * 0.5), 1e-9);
    assert_close(e->zones[0].light.b, 0.8 * 6 / (8 * 0.2), 1e-9);
    arena_free(arena);
}

/* The same, of walls that what glows gives an irradiance of 2, and that glow.
 */
static void one_zone_that_is_shone_at(void **state)
{
    (void)state;
    struct arena *arena = arena_new(0);
    struct enclosure *e = enclosure_new(arena, 1);
    enclosure_wall(e, 0, 8, rgb_grey(0.6), rgb_grey(0), rgb_grey(3));
    enclosure_shine(e, 0, rgb_grey(8 * 2), rgb_grey(8 * 0.6 * 2));
    enclosure_solve(e);
    assert_close(e->zones[0].light.g, 2 / (1 - 0.6), 1e-9);
    assert_close(e->zones[0].sent.g, 3 + 0.6 * 2 / (1 - 0.6), 1e-9);
    arena_free(arena);
}

/* What comes in by lamps, glow and sky goes out by walls and sky. */
static void energy_is_kept(void **state)
{
    (void)state;
    struct arena *arena = arena_new(0);
    struct enclosure *e = enclosure_new(arena, 40);
    double in = 0, out = 0;
    for (uint32_t i = 0; i < 40; i++) {
        rgb albedo = rgb_grey(0.1 + 0.02 * i);
        rgb direct = rgb_grey(i == 7 ? 10 : 0);
        rgb returned = rgb_grey(i == 11 ? 3 : 0);
        enclosure_wall(e, i, 1 + i % 5, albedo, direct, rgb_grey(0));
        enclosure_shine(e, i, rgb_grey(0), returned);
        in += (1 + i % 5) * albedo.r * direct.r + returned.r;
        for (uint32_t k = 1; k <= i && k < 4; k++)
            enclosure_open(e, i, i - k, 0.1 * (i % 3 + k));
    }
    enclosure_sky(e, 39, 2, rgb_grey(0.7));
    in += 2 * 0.7;
    int rounds = enclosure_solve(e);
    for (size_t i = 0; i < 40; i++) {
        const struct zone *z = &e->zones[i];
        assert_true(z->light.r > 0);
        out += (z->whole - z->reflecting.r) * z->light.r + z->sky * z->sent.r;
    }
    assert_close(out / in, 1, 1e-4);
    assert_in_range(rounds, 2, 1000);
    arena_free(arena);
}

/* Measured openings are evened out: six sides of a cube that see each other by
 * a fifth, give or take a tenth, and one that also sees the sky. */
static void zones_see_their_area(void **state)
{
    (void)state;
    struct arena *arena = arena_new(0);
    struct enclosure *e = enclosure_new(arena, 6);
    for (uint32_t i = 0; i < 6; i++) {
        enclosure_wall(e, i, 4, rgb_grey(0.5), rgb_grey(i), rgb_grey(0));
        for (uint32_t k = 0; k < i; k++)
            enclosure_open(e, i, k, 0.8 * (i + k == 4 ? 1.1 : 0.95));
    }
    enclosure_open(e, 1, 1, 0.1);
    enclosure_sky(e, 3, 0.5, rgb_grey(1));
    enclosure_even_out(e);
    enclosure_solve(e);
    for (int i = 0; i < 6; i++) {
        assert_close(e->zones[i].whole, 4, 0.001);
        assert_true(i == 1 || e->zones[i].self < 0.001);
    }
    assert_true(e->zones[1].self > 0.05);
    assert_true(e->zones[3].sky > 0.4);
    arena_free(arena);
}

/* A zone without walls, one that nothing gets into, none at all; walls that
 * swallow nothing. All have finite light. */
static void odd_enclosures(void **state)
{
    (void)state;
    struct arena *arena = arena_new(0);
    struct enclosure *e = enclosure_new(arena, 3);
    enclosure_wall(e, 0, 1, rgb_grey(1.5), rgb_grey(1), rgb_grey(0));
    enclosure_open(e, 0, 1, 1);
    enclosure_solve(e);
    for (int i = 0; i < 3; i++)
        assert_true(isfinite(e->zones[i].light.r));
    assert_true(e->zones[2].light.r == 0);
    e = enclosure_new(arena, 0);
    enclosure_solve(e);
    arena_free(arena);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nodes_stay_in_the_void),
        cmocka_unit_test(paths_along_the_u),
        cmocka_unit_test(chambers_end_at_doors),
        cmocka_unit_test(pieces_fill_the_void),
        cmocka_unit_test(pieces_follow_a_root),
        cmocka_unit_test(one_zone),
        cmocka_unit_test(one_zone_that_is_shone_at),
        cmocka_unit_test(energy_is_kept),
        cmocka_unit_test(zones_see_their_area),
        cmocka_unit_test(odd_enclosures),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
